// Computes each participant's values for the tests: one per method, since the participant, not the
// trial, is the unit of analysis.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/models/order_balance.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// Values as [participant][method]; empty if a participant has none.
using ParticipantValues = std::vector<std::vector<std::optional<double>>>;

/// Returns the compared means over the scenes in which every method's value was measured, so that
/// methods are compared over the same scenes: of times the mean logarithm of seconds, of ratings
/// the mean.
ParticipantValues participant_means(const Dataset& set, std::size_t measure);

/// Returns the values of `method` less those of `reference`, for participants with both.
std::vector<double> paired_differences(const ParticipantValues& values, std::size_t method,
                                       std::size_t reference);

/// The trials of two methods in the same scene by the same participant.
struct PairedTrials {
  /// [participant][scene]: method less reference, of times their logarithms; empty unless both were
  /// measured. Participants and scenes without any are left out.
  std::vector<std::vector<std::optional<double>>> differences;
  std::vector<std::size_t> who;  ///< [participant]: index in the set.
  std::size_t pairs = 0;         ///< Number of measured differences.
  std::size_t censored = 0;      ///< Pairs with at least one right-censored time.

  std::size_t participants() const { return differences.size(); }
  std::size_t scenes() const { return differences.empty() ? 0 : differences.front().size(); }
  /// Returns whether every participant has every scene.
  bool is_complete() const { return pairs == participants() * scenes(); }
  /// Returns each participant's mean over the measured scenes.
  std::vector<double> participant_means() const;
};

/// measure, method and reference are indices in the set.
PairedTrials paired_trials(const Dataset& set, std::size_t measure, std::size_t method,
                           std::size_t reference);

/// Place of a measured value (of times the logarithm) in the session, counted in trials from 0, or
/// in the order of methods within the scene.
enum class OrderOf { trials, methods };
std::vector<OrderedValue> ordered_values(const Dataset& set, std::size_t measure, OrderOf order);

/// Returns the measured values of one method that is not the first in its scene, with the scene as
/// condition. The position is 1 right after the method `previous`, else 0.
std::vector<OrderedValue> values_by_previous(const Dataset& set, std::size_t measure,
                                             std::size_t method, std::size_t previous);

/// A comparison: the indices of its measure, method and reference.
struct ComparedPair {
  std::size_t measure = 0;
  std::size_t method = 0;
  std::size_t reference = 0;
};

/// Returns the pair; empty if the study lacks the planned methods or the numeric measure.
std::optional<ComparedPair> pair_of(const Dataset& set, const study::PlannedComparison& planned);

/// Returns the planned pairs in the plan's order, without those that the study lacks.
std::vector<ComparedPair> planned_pairs(const Dataset& set, const study::AnalysisPlan& plan);

/// Returns all pairs of methods in all numeric measures: first the planned ones, then the others,
/// by measure.
std::vector<ComparedPair> compared_pairs(const Dataset& set, const study::AnalysisPlan& plan);

}  // namespace foveola::analysis
