// Survival analysis of times to a mark, with right-censored trials.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// The time of a mark, or the time at which it was right-censored.
struct TimeToMark {
  double time = 0.0;  ///< Finite, not below 0.
  bool censored = false;
};

/// The curve from one observed time to the next.
struct SurvivalStep {
  double time = 0.0;
  std::size_t at_risk = 0;   ///< Without a mark and not censored before this time.
  std::size_t events = 0;    ///< Marks at this time.
  std::size_t censored = 0;  ///< Censored at this time, after its marks.
  double survival = 1.0;     ///< The share without a mark after this time.
  /// Standard error of `survival`, by Greenwood (1926); empty if the survival is 0.
  std::optional<double> standard_error;
  /// Interval of `survival`, by its complementary log-log transform, which stays within 0 and 1;
  /// empty if the survival is 0 or 1.
  std::optional<Interval> interval;
};

/// Median time to the mark, and its interval, either end of which may not be reached.
struct SurvivalMedian {
  double value = 0.0;
  std::optional<double> low;
  std::optional<double> high;
};

struct SurvivalCurve {
  std::size_t n = 0;
  std::size_t events = 0;
  std::size_t censored = 0;
  std::vector<SurvivalStep> steps;  ///< One per distinct time, ascending.
  /// Empty if the survival stays above a half. The interval contains the times at which the steps'
  /// intervals include a half (Brookmeyer and Crowley 1982, with the log-log transform).
  std::optional<SurvivalMedian> median;
};

/// Returns Kaplan and Meier's (1958) estimate, as R's survfit with conf.type = "log-log". It
/// assumes independent times, and censoring unrelated to them, as by a time limit. Trials of one
/// participant are not independent: their curve is descriptive, and its intervals are too narrow.
SurvivalCurve kaplan_meier(std::span<const TimeToMark> times,
                           double confidence = default_confidence);

/// The mean of the times, each at most a horizon: the area below the curve up to there.
struct RestrictedMean {
  double horizon = 0.0;
  double mean = 0.0;
  double standard_error = 0.0;
};

/// Returns the restricted mean as R's print(survfit, rmean = horizon): if the last time is censored
/// before the horizon, the curve keeps its last value. The horizon is above 0. Empty without times.
std::optional<RestrictedMean> restricted_mean(const SurvivalCurve& curve, double horizon);

}  // namespace foveola::analysis
