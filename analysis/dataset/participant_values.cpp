#include "analysis/dataset/participant_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

/// Returns the compared value: of a time its logarithm.
double compared(const Measure& measure, const Value& value) {
  return measure.is_time() ? std::log(value.number) : value.number;
}

/// Counts scenes in which neither value is missing and at least one is right-censored.
std::size_t censored_pairs(const Dataset& set, std::size_t participant, std::size_t measure,
                           std::size_t method, std::size_t reference) {
  using State = Value::State;
  std::size_t count = 0;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    const State a = set.value(participant, scene, method, measure).state;
    const State b = set.value(participant, scene, reference, measure).state;
    const bool is_known = a != State::missing && b != State::missing;
    count += is_known && (a == State::right_censored || b == State::right_censored) ? 1 : 0;
  }
  return count;
}

bool is_of_pair(const study::PlannedComparison& planned, const std::string& measure,
                const std::string& a, const std::string& b) {
  return planned.measure == measure && ((planned.method == a && planned.baseline == b) ||
                                        (planned.method == b && planned.baseline == a));
}

std::vector<ComparedPair> unplanned_pairs(const Dataset& set, const study::AnalysisPlan& plan,
                                          std::size_t measure) {
  std::vector<ComparedPair> pairs;
  for (std::size_t reference = 0; reference < set.methods.size(); ++reference) {
    for (std::size_t method = reference + 1; method < set.methods.size(); ++method) {
      if (std::ranges::none_of(plan.primary, [&](const auto& planned) {
            return is_of_pair(planned, set.measures[measure].id(), set.methods[method],
                              set.methods[reference]);
          })) {
        pairs.push_back({measure, method, reference});
      }
    }
  }
  return pairs;
}

}  // namespace

ParticipantValues participant_means(const Dataset& set, std::size_t measure) {
  ParticipantValues result;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    std::vector<std::vector<double>> by_method(set.methods.size());
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      if (!set.is_complete(participant, scene, measure)) {
        continue;
      }
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        by_method[method].push_back(
            compared(set.measures[measure], set.value(participant, scene, method, measure)));
      }
    }
    std::vector<std::optional<double>>& means = result.emplace_back();
    for (const std::vector<double>& values : by_method) {
      means.push_back(mean(values));
    }
  }
  return result;
}

std::vector<double> paired_differences(const ParticipantValues& values, std::size_t method,
                                       std::size_t reference) {
  std::vector<double> differences;
  for (const auto& row : values) {
    if (row[method] && row[reference]) {
      differences.push_back(*row[method] - *row[reference]);
    }
  }
  return differences;
}

std::vector<double> PairedTrials::participant_means() const {
  std::vector<double> means;
  for (const auto& row : differences) {
    std::vector<double> present;
    for (const std::optional<double>& difference : row) {
      if (difference) {
        present.push_back(*difference);
      }
    }
    means.push_back(mean(present).value());
  }
  return means;
}

PairedTrials paired_trials(const Dataset& set, std::size_t measure, std::size_t method,
                           std::size_t reference) {
  const auto difference = [&](std::size_t participant, std::size_t scene) {
    const Value& of_method = set.value(participant, scene, method, measure);
    const Value& of_reference = set.value(participant, scene, reference, measure);
    return of_method.is_measured() && of_reference.is_measured()
               ? std::optional(compared(set.measures[measure], of_method) -
                               compared(set.measures[measure], of_reference))
               : std::nullopt;
  };
  std::vector<std::size_t> scenes;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
      if (difference(participant, scene)) {
        scenes.push_back(scene);
        break;
      }
    }
  }
  PairedTrials trials;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    std::vector<std::optional<double>> row = transformed(
        scenes, [&](const std::size_t scene) { return difference(participant, scene); });
    const auto present = static_cast<std::size_t>(
        std::ranges::count_if(row, [](const auto& value) { return value.has_value(); }));
    if (present > 0) {
      trials.pairs += present;
      trials.differences.push_back(std::move(row));
      trials.who.push_back(participant);
    }
    trials.censored += censored_pairs(set, participant, measure, method, reference);
  }
  return trials;
}

std::vector<OrderedValue> ordered_values(const Dataset& set, std::size_t measure, OrderOf order) {
  std::vector<OrderedValue> values;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        const Value& value = set.value(participant, scene, method, measure);
        if (value.is_measured()) {
          const Trial& trial = set.trial(participant, scene, method);
          const int position =
              order == OrderOf::trials ? trial.trial_position : trial.method_position;
          values.push_back({participant, scene * set.methods.size() + method,
                            static_cast<double>(position), compared(set.measures[measure], value)});
        }
      }
    }
  }
  return values;
}

std::vector<OrderedValue> values_by_previous(const Dataset& set, std::size_t measure,
                                             std::size_t method, std::size_t previous) {
  std::vector<OrderedValue> values;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      const Value& value = set.value(participant, scene, method, measure);
      const int position = set.trial(participant, scene, method).method_position;
      if (!value.is_measured() || position == 0) {
        continue;
      }
      const int of_previous = set.trial(participant, scene, previous).method_position;
      values.push_back({participant, scene, of_previous == position - 1 ? 1.0 : 0.0,
                        compared(set.measures[measure], value)});
    }
  }
  return values;
}

std::optional<ComparedPair> pair_of(const Dataset& set, const study::PlannedComparison& planned) {
  const auto measure = set.measure_named(planned.measure);
  const auto method = position_of(set.methods, planned.method);
  const auto reference = position_of(set.methods, planned.baseline);
  if (!measure || !method || !reference || !set.measures[*measure].is_numeric()) {
    return std::nullopt;
  }
  return ComparedPair{*measure, *method, *reference};
}

std::vector<ComparedPair> planned_pairs(const Dataset& set, const study::AnalysisPlan& plan) {
  std::vector<ComparedPair> pairs;
  for (const study::PlannedComparison& planned : plan.primary) {
    if (const std::optional<ComparedPair> pair = pair_of(set, planned)) {
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

std::vector<ComparedPair> compared_pairs(const Dataset& set, const study::AnalysisPlan& plan) {
  std::vector<ComparedPair> pairs = planned_pairs(set, plan);
  for (std::size_t measure = 0; measure < set.measures.size(); ++measure) {
    if (set.measures[measure].is_numeric()) {
      const std::vector<ComparedPair> others = unplanned_pairs(set, plan, measure);
      pairs.insert(pairs.end(), others.begin(), others.end());
    }
  }
  return pairs;
}

}  // namespace foveola::analysis
