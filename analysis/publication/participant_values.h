// Each participant's values for the tests: one per method, since the participant, not the trial, is
// the unit of analysis.
#pragma once

#include <optional>
#include <vector>

#include "analysis/publication/analysis_set.h"
#include "analysis/statistics/order_effect.h"

namespace foveola::analysis {

/// Values as [participant][method]; empty where a participant has none.
using ParticipantValues = std::vector<std::vector<std::optional<double>>>;

/// The mean logarithm of the times in seconds, over the scenes in which every method's time was
/// measured, so that the methods are compared over the same scenes.
ParticipantValues mean_log_times(const AnalysisSet& set, Mark mark);

/// The mean artifact rating, over the scenes in which every method was rated.
ParticipantValues mean_ratings(const AnalysisSet& set);

/// The values of `method` less those of `reference`, of the participants who have both.
std::vector<double> paired_differences(const ParticipantValues& values, std::size_t method,
                                       std::size_t reference);

/// The logarithms of all measured times with their place in the session, counted in trials from 0,
/// or in the order of methods within the scene.
enum class OrderOf { trials, methods };
std::vector<OrderedValue> ordered_log_times(const AnalysisSet& set, Mark mark, OrderOf order);

}  // namespace foveola::analysis
