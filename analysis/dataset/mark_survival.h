// Times to a mark: trials that never reached it, and times that stand out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/survival.h"

namespace foveola::analysis {

/// One mark with one method, over all trials in which it was reached or right-censored.
struct MarkSurvival {
  std::string mark;    ///< Its id.
  std::string method;  ///< Its id.
  SurvivalCurve curve;
  /// In seconds, to the earliest time at which any method's time was right-censored, or else to the
  /// longest time of the mark: the same for all methods.
  std::optional<RestrictedMean> restricted;
  std::optional<Interval> limits_s;  ///< The earliest and latest of its right-censored times.
};

/// [mark][method], in the set's order.
std::vector<MarkSurvival> mark_survival(const Dataset& set);

/// "od did not reach the mark outline within 180 s in 23 of 80 trials." for each that has
/// right-censored times.
std::vector<std::string> unreached_in_words(const std::vector<MarkSurvival>& survival);

struct OutlyingTime {
  std::string mark;  ///< Its id.
  std::string participant;
  std::string scene;
  std::string method;
  double seconds = 0.0;
  double times_expected = 1.0;  ///< How many times the time that was expected.
  double studentized = 0.0;     ///< Its studentized residual when it was taken out.
};

/// The residual_outliers of log times, mark by mark, the farthest first. They stay in all results:
/// whoever leaves one out needs a reason that is not its value.
std::vector<OutlyingTime> outlying_times(const Dataset& set);

}  // namespace foveola::analysis
