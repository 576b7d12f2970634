#include "analysis/publication/participant_values.h"

#include <cmath>
#include <functional>

namespace foveola::analysis {
namespace {

/// A cell's value, if it has one.
using CellValue = std::function<std::optional<double>(const Cell&)>;

/// The values of all methods in a scene; empty if one has none.
std::optional<std::vector<double>> complete_scene(const AnalysisSet& set, std::size_t participant,
                                                  std::size_t scene, const CellValue& value_of) {
  std::vector<double> values;
  for (std::size_t method = 0; method < set.methods.size(); ++method) {
    const std::optional<double> value = value_of(set.cell(participant, scene, method));
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

ParticipantValues means_over_complete_scenes(const AnalysisSet& set, const CellValue& value_of) {
  ParticipantValues result;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    std::vector<std::vector<double>> by_method(set.methods.size());
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      if (const auto values = complete_scene(set, participant, scene, value_of)) {
        for (std::size_t method = 0; method < values->size(); ++method) {
          by_method[method].push_back((*values)[method]);
        }
      }
    }
    std::vector<std::optional<double>>& means = result.emplace_back();
    for (const std::vector<double>& values : by_method) {
      means.push_back(mean(values));
    }
  }
  return result;
}

}  // namespace

ParticipantValues mean_log_times(const AnalysisSet& set, Mark mark) {
  return means_over_complete_scenes(set, [mark](const Cell& cell) {
    const MarkTime& time = cell.time(mark);
    return time.state == MarkTime::State::measured ? std::optional(std::log(time.seconds))
                                                   : std::nullopt;
  });
}

ParticipantValues mean_ratings(const AnalysisSet& set) {
  return means_over_complete_scenes(set, [](const Cell& cell) {
    return cell.rating ? std::optional(static_cast<double>(*cell.rating)) : std::nullopt;
  });
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

std::vector<OrderedValue> ordered_log_times(const AnalysisSet& set, Mark mark, OrderOf order) {
  std::vector<OrderedValue> values;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        const Cell& cell = set.cell(participant, scene, method);
        if (cell.time(mark).state == MarkTime::State::measured) {
          const int position =
              order == OrderOf::trials ? cell.trial_position : cell.method_position;
          values.push_back({participant, scene * set.methods.size() + method,
                            static_cast<double>(position), std::log(cell.time(mark).seconds)});
        }
      }
    }
  }
  return values;
}

}  // namespace foveola::analysis
