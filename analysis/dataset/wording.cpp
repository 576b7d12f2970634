#include "analysis/dataset/wording.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/reading/read_procedure.h"

namespace foveola::analysis {
namespace {

using Labels = std::vector<std::string>;

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
  const auto known = std::ranges::find_if(amended, [&](const AmendedLabels& entry) {
    return entry.measure == other.measure && entry.labels == other.labels;
  });
  if (known != amended.end()) {
    ++known->sessions;
  } else {
    amended.push_back(other);
  }
}

struct PublishedMethod {
  std::string_view id;
  std::string_view label;
  std::string_view meaning;
};

constexpr std::array published_methods = {
    PublishedMethod{"od", "OD", "omnidirectional preview"},
    PublishedMethod{"vp", "VP", "viewport preview"},
    PublishedMethod{"fv", "FV", "foveated preview"},
};

const PublishedMethod* find_published(const std::string& id) {
  for (const PublishedMethod& method : published_methods) {
    if (method.id == id) {
      return &method;
    }
  }
  return nullptr;
}

}  // namespace

std::string method_label(const std::string& method) {
  const PublishedMethod* published = find_published(method);
  return published != nullptr ? std::string(published->label) : method;
}

std::string_view method_meaning(const std::string& method) {
  const PublishedMethod* published = find_published(method);
  return published != nullptr ? published->meaning : std::string_view();
}

std::string mean_and_deviation(const Description& description, int decimals) {
  std::string text = fixed(description.mean, decimals);
  if (description.standard_deviation) {
    text += " ± " + fixed(description.standard_deviation, decimals);
  }
  return text;
}

std::string with_interval(const std::optional<Estimate>& estimate, int decimals) {
  if (!estimate) {
    return no_value;
  }
  std::string text = fixed(estimate->value, decimals);
  if (estimate->interval) {
    text += fmt::format(" [{}, {}]", fixed(estimate->interval->low, decimals),
                        fixed(estimate->interval->high, decimals));
  }
  return text;
}

std::string join_sentences(const std::string& sentence, const std::string& more) {
  return more.empty() ? sentence : sentence + " " + more;
}

std::string count_with_noun(std::size_t count, std::string_view singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

std::string comma_list(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string censored_times_in_words(const Dataset& set) {
  const std::size_t trials = set.participants.size() * set.scenes.size();
  std::vector<std::string> counts;
  for (const std::size_t mark : set.times()) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      if (const std::size_t censored = set.censored(mark, method); censored > 0) {
        counts.push_back(fmt::format("{} of {} {} times of {}", censored, trials,
                                     set.measures[mark].id(), method_label(set.methods[method])));
      }
    }
  }
  return counts.empty() ? ""
                        : fmt::format(
                              "Right-censored times are left out ({}), which favours the "
                              "method with the censored times.",
                              comma_list(counts));
}

std::string participants_in_words(const StudyTables& tables) {
  const std::string adjective = tables.set.kind == "human" ? "" : tables.set.kind + " ";
  return count_with_noun(tables.set.participants.size(), adjective + "participant");
}

namespace {

std::string notice_of_kind(const StudyTables& tables) {
  if (tables.set.kind == "simulated") {
    return "Simulated data";
  }
  if (tables.set.kind == "pilot") {
    return "Pilot data";
  }
  return tables.has_simulated ? "Without the simulated sessions" : "";
}

}  // namespace

std::string data_notice(const StudyTables& tables) {
  const std::string kind = notice_of_kind(tables);
  if (tables.set.record != "changed") {
    return kind;
  }
  return (kind.empty() ? "From" : kind + ", from") + " a changed record";
}

namespace {

std::string simulation_in_words(const study::SimulationFacts& simulation) {
  std::string text;
  if (simulation.predicted && simulation.injected.empty()) {
    text += " Their stimuli were not rendered but predicted from pilot renders.";
  }
  if (!simulation.injected.empty()) {
    text +=
        fmt::format(" Their times were drawn, with injected effects ({}).", simulation.injected);
  }
  if (simulation.samples_per_second) {
    text += fmt::format(" The machine traced {:.0f} samples per second, unlike the protocol's.",
                        *simulation.samples_per_second);
  }
  if (simulation.scale != 1.0) {
    text += fmt::format(" Film and machine were scaled down by {:g}.", simulation.scale);
  }
  if (simulation.whole_participants) {
    text += fmt::format(" They are a part of a study of {} participants.",
                        *simulation.whole_participants);
  }
  return text;
}

}  // namespace

std::string data_warning(const StudyTables& tables) {
  if (tables.set.kind == "simulated") {
    return "Simulated data: every number here comes from simulated participants, not from people." +
           (tables.simulation ? simulation_in_words(*tables.simulation) : "");
  }
  if (tables.set.kind == "pilot") {
    return "Pilot data: these sessions tested the procedure and are not the study.";
  }
  return tables.has_simulated
             ? "The study's file also has simulated sessions; no number here uses them."
             : "";
}

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
