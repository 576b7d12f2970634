#include "analysis/publication/rating_scale.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/toml_reader.h"
#include "study/protocol/analysed_measures.h"
#include "study/protocol/read_procedure.h"

namespace foveola::analysis {
namespace {

constexpr int points = 5;

std::optional<study::Question> artifacts_in(const std::string& protocol_text) {
  const std::string file = "the study's protocol";
  const toml::table toml = parse_toml(file, protocol_text, "restore the study's file");
  TomlReader protocol(file, toml, "");
  const std::vector<study::Question> ratings =
      study::read_ratings(protocol, study::read_marks(protocol));
  const auto found = std::find_if(
      ratings.begin(), ratings.end(),
      [](const study::Question& rating) { return rating.id == study::analysed_rating; });
  return found != ratings.end() ? std::optional(*found) : std::nullopt;
}

std::vector<std::string> labels_of(const std::optional<study::Question>& question) {
  return question && study::is_analysed(*question) ? question->labels : std::vector<std::string>();
}

/// The scales of the sessions whose labels were other ones than `labels`.
std::vector<AmendedLabels> amended_labels(const study::StudyRecords& records,
                                          const std::vector<std::string>& participants,
                                          const std::vector<std::string>& labels) {
  const std::set<std::string> analysed(participants.begin(), participants.end());
  std::vector<AmendedLabels> amended;
  std::set<std::pair<std::string, std::vector<std::string>>> counted;
  for (const auto& [participant, amendment] : records.amended) {
    if (!analysed.contains(participant)) {
      continue;
    }
    std::vector<std::string> own = labels_of(artifacts_in(amendment.text));
    if (own == labels || !counted.insert({participant, own}).second) {
      continue;
    }
    const auto known =
        std::find_if(amended.begin(), amended.end(),
                     [&](const AmendedLabels& other) { return other.labels == own; });
    if (known != amended.end()) {
      ++known->sessions;
    } else {
      amended.push_back({std::move(own), 1});
    }
  }
  return amended;
}

std::string bracketed(int point, const std::string& label) {
  return fmt::format("{} ({})", point, label);
}

std::string points_in_brackets(const std::vector<std::string>& labels) {
  if (labels.size() == 2) {
    return bracketed(1, labels[0]) + " to " + bracketed(points, labels[1]);
  }
  std::vector<std::string> all;
  for (const std::string& label : labels) {
    all.push_back(bracketed(static_cast<int>(all.size()) + 1, label));
  }
  return all.empty() ? fmt::format("1 to {}", points) : fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

bool RatingScale::is_analysed() const { return question && study::is_analysed(*question); }

RatingScale rating_scale_of(const study::StudyRecords& records,
                            const std::vector<std::string>& participants) {
  RatingScale scale{.question = artifacts_in(records.protocol_text), .amended = {}};
  scale.amended = amended_labels(records, participants, labels_of(scale.question));
  return scale;
}

std::string points_in_words(const RatingScale& scale) {
  const std::vector<std::string> labels = labels_of(scale.question);
  return labels.size() == 2 ? fmt::format("1 {} to {} {}", labels[0], points, labels[1])
                            : points_in_brackets(labels);
}

std::string points_in_brackets(const RatingScale& scale) {
  return points_in_brackets(labels_of(scale.question));
}

std::string notes_on(const RatingScale& scale) {
  if (!scale.question) {
    return " The protocol asks for no such rating.";
  }
  if (!scale.is_analysed()) {
    return " The protocol’s own scale is another one: its answers are in the record only.";
  }
  std::string text;
  for (const AmendedLabels& amended : scale.amended) {
    text += fmt::format(" In {} analysed session{}, by an amended protocol, the points were {}.",
                        amended.sessions, amended.sessions == 1 ? "" : "s",
                        points_in_brackets(amended.labels));
  }
  return text;
}

}  // namespace foveola::analysis
