#include "analysis/dataset/amended_labels.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/toml_file.h"
#include "renderer/base/toml_reader.h"
#include "study/protocol/read_procedure.h"

namespace foveola::analysis {
namespace {

using Labels = std::vector<std::string>;

/// The labels of each rating of a protocol's text, by its id.
std::map<std::string, Labels> labels_in(const std::string& protocol_text) {
  const std::string where = "an amended protocol in the study's file";
  const toml::table toml = parse_toml(where, protocol_text, "restore the study's file");
  TomlReader protocol(where, toml, "");
  std::map<std::string, Labels> labels;
  for (const study::Question& rating : study::read_ratings(protocol, study::read_marks(protocol))) {
    labels[rating.id] = rating.labels;
  }
  return labels;
}

void count(const AmendedLabels& other, std::vector<AmendedLabels>& amended) {
  const auto known = std::find_if(amended.begin(), amended.end(), [&](const AmendedLabels& entry) {
    return entry.measure == other.measure && entry.labels == other.labels;
  });
  if (known != amended.end()) {
    ++known->sessions;
  } else {
    amended.push_back(other);
  }
}

}  // namespace

std::vector<AmendedLabels> amended_labels(const study::StudyRecords& records,
                                          const std::vector<std::string>& participants) {
  const std::set<std::string> analysed(participants.begin(), participants.end());
  std::vector<AmendedLabels> amended;
  std::set<std::pair<std::string, std::pair<std::size_t, Labels>>> counted;
  for (const auto& [participant, amendment] : records.amended) {
    if (!analysed.contains(participant)) {
      continue;
    }
    const std::map<std::string, Labels> labels = labels_in(amendment.text);
    for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
      const study::Question& rating = records.measures[measure].question;
      const auto own = labels.find(rating.id);
      if (own != labels.end() && own->second != rating.labels &&
          counted.insert({participant, {measure, own->second}}).second) {
        count({measure, own->second, 1}, amended);
      }
    }
  }
  return amended;
}

std::string amendments_of_scale(const Dataset& set, std::size_t measure) {
  std::string text;
  for (const AmendedLabels& amended : set.amended_labels) {
    if (amended.measure != measure) {
      continue;
    }
    Measure as_amended = set.measures[measure];
    as_amended.question.labels = amended.labels;
    text += fmt::format(" In {} analysed session{}, by an amended protocol, the points were {}.",
                        amended.sessions, amended.sessions == 1 ? "" : "s",
                        study::scale_in_words(as_amended));
  }
  return text;
}

std::string scale_with_amendments(const Dataset& set, std::size_t measure) {
  const std::string amendments = amendments_of_scale(set, measure);
  return study::scale_in_words(set.measures[measure]) +
         (amendments.empty() ? "" : "." + amendments);
}

}  // namespace foveola::analysis
