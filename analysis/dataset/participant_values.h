// Each participant's values for the tests: one per method, since the participant, not the trial, is
// the unit of analysis.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/order_effect.h"

namespace foveola::analysis {

/// Values as [participant][method]; empty where a participant has none.
using ParticipantValues = std::vector<std::vector<std::optional<double>>>;

/// The means that are compared, over the scenes in which every method's value was measured, so that
/// the methods are compared over the same scenes: of times the mean logarithm of seconds, of
/// ratings the mean.
ParticipantValues participant_means(const Dataset& set, std::size_t measure);

/// The values of `method` less those of `reference`, of the participants who have both.
std::vector<double> paired_differences(const ParticipantValues& values, std::size_t method,
                                       std::size_t reference);

/// All measured values, of times their logarithms, with their place in the session, counted in
/// trials from 0, or in the order of methods within the scene.
enum class OrderOf { trials, methods };
std::vector<OrderedValue> ordered_values(const Dataset& set, std::size_t measure, OrderOf order);

}  // namespace foveola::analysis
