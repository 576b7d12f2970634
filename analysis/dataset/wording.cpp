#include "analysis/dataset/wording.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace foveola::analysis {
namespace {

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

constexpr std::string_view no_value = "–";

}  // namespace

std::string method_label(const std::string& method) {
  const PublishedMethod* published = find_published(method);
  return published != nullptr ? std::string(published->label) : method;
}

std::string_view method_meaning(const std::string& method) {
  const PublishedMethod* published = find_published(method);
  return published != nullptr ? published->meaning : std::string_view();
}

std::string fixed(std::optional<double> value, int decimals) {
  if (!value) {
    return std::string(no_value);
  }
  const std::string text = fmt::format("{:.{}f}", *value, decimals);
  const bool is_negative_zero = text.find_first_of("123456789") == std::string::npos &&
                                std::isfinite(*value) && text.front() == '-';
  return is_negative_zero ? text.substr(1) : text;
}

std::string with_sign(std::optional<double> value, int decimals) {
  const std::string text = fixed(value, decimals);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return value && *value > 0.0 && !is_zero ? "+" + text : text;
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
    return std::string(no_value);
  }
  std::string text = fixed(estimate->value, decimals);
  if (estimate->interval) {
    text += fmt::format(" [{}, {}]", fixed(estimate->interval->low, decimals),
                        fixed(estimate->interval->high, decimals));
  }
  return text;
}

std::string p_value(double p) {
  constexpr double smallest_printed = 1e-300;
  return p < smallest_printed ? "< 1e-300" : fmt::format("{:#.2g}", p);
}

std::string joined(const std::string& sentence, const std::string& more) {
  return more.empty() ? sentence : sentence + " " + more;
}

std::string counted(std::size_t count, std::string_view singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& names) {
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
                              "method whose time ran out.",
                              listed(counts));
}

std::string participants_in_words(const StudyTables& tables) {
  const std::string adjective = tables.set.kind == "human" ? "" : tables.set.kind + " ";
  return counted(tables.set.participants.size(), adjective + "participant");
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
    text += " What they looked at was not rendered but predicted from pilot renders.";
  }
  if (!simulation.injected.empty()) {
    text +=
        fmt::format(" Their times were drawn, with injected effects ({}).", simulation.injected);
  }
  if (simulation.samples_per_second) {
    text += fmt::format(" The machine took {:.0f} samples a second, which is not the protocol's.",
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
    return "Pilot data: these sessions tried out the procedure and are not the study.";
  }
  return tables.has_simulated
             ? "The study's file also holds simulated sessions; no number here uses them."
             : "";
}

}  // namespace foveola::analysis
