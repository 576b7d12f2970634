// Each participant's values for the tests: one per method, since the participant, not the trial, is
// the unit of analysis.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/models/order_balance.h"
#include "study/protocol/protocol.h"

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

/// The trials of two methods in the same scene by the same participant.
struct PairedTrials {
  /// [participant][scene]: method less reference, of times their logarithms; empty where one of
  /// both was not measured. Only participants with at least one, and scenes that somebody has.
  std::vector<std::vector<std::optional<double>>> differences;
  std::vector<std::size_t> who;  ///< [participant]: its index in the set.
  std::size_t pairs = 0;         ///< Differences that are there.
  std::size_t censored = 0;      ///< Pairs of which at least one time is right-censored.

  std::size_t participants() const { return differences.size(); }
  std::size_t scenes() const { return differences.empty() ? 0 : differences.front().size(); }
  /// Whether every participant has every scene.
  bool is_complete() const { return pairs == participants() * scenes(); }
  /// Each participant's mean over the scenes that there are.
  std::vector<double> participant_means() const;
};

/// measure, method and reference are indices in the set.
PairedTrials paired_trials(const Dataset& set, std::size_t measure, std::size_t method,
                           std::size_t reference);

/// All measured values, of times their logarithms, with their place in the session, counted in
/// trials from 0, or in the order of methods within the scene.
enum class OrderOf { trials, methods };
std::vector<OrderedValue> ordered_values(const Dataset& set, std::size_t measure, OrderOf order);

/// The measured values of one method that is not the first in its scene, with the scene as
/// condition; the position is 1 right after the method `previous`, else 0.
std::vector<OrderedValue> values_by_previous(const Dataset& set, std::size_t measure,
                                             std::size_t method, std::size_t previous);

/// A comparison to be made: the indices of its measure, method and reference.
struct ComparedPair {
  std::size_t measure = 0;
  std::size_t method = 0;
  std::size_t reference = 0;
};

/// Empty if the study does not have the planned measure, in numbers, or methods.
std::optional<ComparedPair> pair_of(const Dataset& set, const study::PlannedComparison& planned);

/// The planned pairs as the plan has them, without those that the study does not have.
std::vector<ComparedPair> planned_pairs(const Dataset& set, const study::AnalysisPlan& plan);

/// All pairs of methods in all measures that are numbers: first the planned ones, then the others,
/// measure by measure.
std::vector<ComparedPair> compared_pairs(const Dataset& set, const study::AnalysisPlan& plan);

}  // namespace foveola::analysis
