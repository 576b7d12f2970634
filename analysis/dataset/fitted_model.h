// Models of a comparison fitted by another program, R with its packages.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

enum class EffectScale {
  ratio,       ///< Of times, method over reference; computed as its natural logarithm.
  odds_ratio,  ///< Of a higher rating; computed as its natural logarithm.
  points,      ///< Of a rating, method less reference.
};

inline const char* name_of(EffectScale scale) {
  return scale == EffectScale::ratio        ? "ratio"
         : scale == EffectScale::odds_ratio ? "odds ratio"
                                            : "points";
}

/// Converts a computed number to a ratio or points.
inline double in_scale(EffectScale scale, double computed) {
  return scale == EffectScale::points ? computed : std::exp(computed);
}
inline Interval in_scale(EffectScale scale, const Interval& computed) {
  return {in_scale(scale, computed.low), in_scale(scale, computed.high)};
}

/// The estimate without each participant in turn.
struct Influence {
  Interval estimates;        ///< Minimum and maximum, as computed.
  std::string without_low;   ///< Code of the participant left out for the minimum.
  std::string without_high;  ///< Code of the participant left out for the maximum.
};

/// One model of one measure with two methods.
struct FittedModel {
  std::string model;  ///< "crossed", "tobit" or "ordinal".
  std::string measure;
  std::string method;
  std::string reference;
  EffectScale scale = EffectScale::ratio;
  /// "fitted", "separated", "singular" or "failed"; the latter two lack a fit.
  std::string status;
  /// The estimates, as the scale is computed.
  struct Fit {
    double estimate = 0.0;  ///< Infinite if the methods' ratings are separated.
    std::optional<double> standard_error;
    std::optional<double> degrees_of_freedom;
    std::optional<Interval> interval;
    double p = 0.0;
  };
  std::optional<Fit> fit;
  std::size_t trials = 0;
  std::size_t participants = 0;
  std::size_t scenes = 0;
  std::size_t censored = 0;  ///< Trials that are right-censored.
  // Standard deviations of the difference between the methods, if the model has them.
  std::optional<double> participant_sd;
  std::optional<double> scene_sd;
  std::optional<double> residual_sd;
  std::optional<Influence> influence;
  std::string note;  ///< Reason why there is no fit, or a warning about it.
};

struct FittedModels {
  std::vector<FittedModel> models;
  std::vector<std::pair<std::string, std::string>> versions;  ///< Of R and its packages.
  std::string missing;  ///< Reason why no model was fitted; empty if R ran.

  /// Returns the model, with a fit or the reason why there is none; null if it was not tried.
  const FittedModel* find(const std::string& model, const std::string& measure,
                          const std::string& method, const std::string& reference) const {
    const auto found = std::ranges::find_if(models, [&](const FittedModel& row) {
      return row.model == model && row.measure == measure && row.method == method &&
             row.reference == reference;
    });
    return found != models.end() ? &*found : nullptr;
  }
};

}  // namespace foveola::analysis
