#include "analysis/dataset/participant_values.h"

#include <cmath>

namespace foveola::analysis {
namespace {

/// A measured value as it is compared: of a time its logarithm.
double compared(const Measure& measure, const Value& value) {
  return measure.kind == MeasureKind::time ? std::log(value.number) : value.number;
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

}  // namespace foveola::analysis
