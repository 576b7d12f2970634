// Times to a mark, with right-censored trials, and outlying times.
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
  /// In seconds, up to a horizon common to all methods. The horizon is the earliest right-censored
  /// time of any method, or the maximum time if none is censored.
  std::optional<RestrictedMean> restricted;
  std::optional<Interval>
      censored_range_s;  ///< The minimum and maximum of its right-censored times.
};

/// Returns [mark][method], in the set's order.
std::vector<MarkSurvival> mark_survival(const Dataset& set);

/// Returns "OD did not reach the mark outline within 180 s in 23 of 80 trials." for each method
/// with right-censored times.
std::vector<std::string> unreached_in_words(const std::vector<MarkSurvival>& survival);

struct OutlyingTime {
  std::string mark;  ///< Its id.
  std::string participant;
  std::string scene;
  std::string method;
  double seconds = 0.0;
  double ratio_to_expected = 1.0;  ///< Time / time expected by the model.
  double studentized = 0.0;        ///< Its externally studentized residual.
};

/// Returns the residual_outliers (models/additive_fit.h) of log times, by mark, the most distant
/// first. They stay in all results.
std::vector<OutlyingTime> outlying_times(const Dataset& set);

}  // namespace foveola::analysis
