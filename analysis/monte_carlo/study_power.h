// Simulates the power of a planned study: the share of drawn studies whose planned analysis finds
// the expected effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <vector>

#include "analysis/dataset/fitted_model.h"
#include "analysis/dataset/primary_analysis.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Number of studies drawn before any of them is analysed, since programs that fit models start
/// slowly.
inline constexpr std::size_t studies_drawn_together = 25;

/// Fits models to studies by another program, in their order.
using ModelFitter =
    std::function<std::vector<FittedModels>(const std::vector<study::StudyRecords>&)>;

struct PowerSimulation {
  std::size_t studies = 2000;  ///< Per number of participants; at least one.
  std::uint64_t seed = 1;
  int threads = 0;           ///< 0: one per core; the result does not depend on it.
  ModelFitter fit_models{};  ///< Empty if no model is fitted by another program.
};

/// Results of one planned comparison over all studies.
struct ComparisonPower {
  std::size_t significant = 0;  ///< Studies whose P, adjusted by Holm's method, is below alpha.
  /// Studies by the analysis of their P. Studies without P are in none.
  std::map<AnalysisKind, std::size_t> analyses;
  std::size_t stand_ins = 0;  ///< Studies in which another analysis replaces the planned one.
};

/// Results of all studies of one size.
struct StudyPower {
  std::size_t participants = 0;  ///< Number that takes part, including withdrawals.
  std::size_t studies = 0;
  std::vector<ComparisonPower> comparisons;  ///< In the plan's order.
  std::size_t all_significant = 0;  ///< Studies in which every planned comparison is significant.
  double analysed = 0.0;            ///< Mean number of participants who do not withdraw.
  /// [mark][method]: share of right-censored times; 0 without times.
  std::vector<std::vector<double>> censored;
};

/// A share of the studies, with Clopper and Pearson's interval of its Monte Carlo error.
struct PowerShare {
  double value = 0.0;
  Interval interval;
};
PowerShare share_of(std::size_t hits, const StudyPower& power);

/// Draws studies of this size and analyses each as its protocol plans. The first participants of a
/// study are the same for all sizes, so that power hardly ever falls with size by chance. Empty
/// when `stop` was requested.
std::optional<StudyPower> simulate_study_power(const ExpectedStudy& expected,
                                               std::size_t participants,
                                               const PowerSimulation& simulation,
                                               const std::stop_token& stop = {});

/// Returns the number of studies in which the planned comparison is significant, or, without one,
/// all of them together.
std::size_t hits_of(const StudyPower& power, std::optional<std::size_t> comparison);

struct PowerTarget {
  double power = 0.9;
  std::optional<std::size_t> planned;  ///< A size that must be among the results.
  std::size_t most = 256;              ///< Maximum size to try.
};

/// Returns the power by sizes, from four participants on, dense enough to contain the minimum sizes
/// with which each planned comparison, and all together, reach the target, if `most` suffices.
/// `on_size` is called before each size is simulated. Empty when `stop` was requested.
std::vector<StudyPower> power_curve(const ExpectedStudy& expected, const PowerTarget& target,
                                    const PowerSimulation& simulation,
                                    const std::function<void(std::size_t)>& on_size,
                                    const std::stop_token& stop = {});

/// Returns the minimum size of the curve from which on the target is reached; empty if it is not.
std::optional<std::size_t> fewest_participants(const std::vector<StudyPower>& curve,
                                               std::optional<std::size_t> comparison, double power);

}  // namespace foveola::analysis
