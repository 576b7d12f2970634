// The power of a planned study: how often its planned analysis finds what is expected of it, over
// studies that are drawn.
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

/// So many studies are drawn before any of them is analysed, since a program that fits models takes
/// long to start.
inline constexpr std::size_t studies_drawn_together = 25;

/// Fits models by another program to studies, in their order.
using ModelFitter =
    std::function<std::vector<FittedModels>(const std::vector<study::StudyRecords>&)>;

struct PowerSimulation {
  std::size_t studies = 2000;  ///< Of each number of participants; one at least.
  std::uint64_t seed = 1;
  int threads = 0;           ///< 0 takes every core; the result does not depend on it.
  ModelFitter fit_models{};  ///< Empty if no model is fitted by another program.
};

/// One planned comparison in all studies.
struct ComparisonPower {
  std::size_t significant = 0;  ///< Studies in which P, adjusted by Holm's method, is below alpha.
  /// Studies by the analysis that P is of. Those without a P-value are in none.
  std::map<AnalysisKind, std::size_t> analyses;
  std::size_t stand_ins = 0;  ///< Studies in which this is not the analysis that is planned.
};

/// What becomes of studies with so many participants.
struct StudyPower {
  std::size_t participants = 0;  ///< Those who take part, with those who withdraw.
  std::size_t studies = 0;
  std::vector<ComparisonPower> comparisons;  ///< In the plan's order.
  std::size_t all_significant = 0;           ///< Studies in which every planned comparison is.
  double analysed = 0.0;                     ///< Mean number of participants who do not withdraw.
  /// [mark][method]: the share of times that are right-censored; of none, 0.
  std::vector<std::vector<double>> censored;
};

/// A share of the studies, with Clopper and Pearson's interval, which is the Monte Carlo error.
struct PowerShare {
  double value = 0.0;
  Interval interval;
};
PowerShare share_of(std::size_t hits, const StudyPower& power);

/// Draws studies with so many participants and analyses each as its protocol plans. The first
/// participants of a study are the same, however many there are, so that power hardly ever falls
/// with their number by chance. Empty when `stop` was requested.
std::optional<StudyPower> simulate_study_power(const ExpectedStudy& expected,
                                               std::size_t participants,
                                               const PowerSimulation& simulation,
                                               const std::stop_token& stop = {});

/// How often the planned comparison is significant, or, without one, all of them together.
std::size_t hits_of(const StudyPower& power, std::optional<std::size_t> comparison);

struct PowerTarget {
  double power = 0.9;
  std::optional<std::size_t> planned;  ///< A number of participants that is among the results.
  std::size_t most = 256;              ///< No more participants are tried.
};

/// The power by numbers of participants, from four on, so close together that the fewest are among
/// them with which each planned comparison, and all together, reach the target, as far as they do
/// with `most`. `on_size` is called before each number is simulated. Empty when `stop` was
/// requested.
std::vector<StudyPower> power_curve(const ExpectedStudy& expected, const PowerTarget& target,
                                    const PowerSimulation& simulation,
                                    const std::function<void(std::size_t)>& on_size,
                                    const std::stop_token& stop = {});

/// The fewest participants of the curve from which on the target is reached; empty if it is not.
std::optional<std::size_t> fewest_participants(const std::vector<StudyPower>& curve,
                                               std::optional<std::size_t> comparison, double power);

}  // namespace foveola::analysis
