// What the difference between two methods is measured in.
#pragma once

#include <cmath>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

enum class EffectScale {
  ratio,       ///< Of times, method over reference; computed with as its natural logarithm.
  odds_ratio,  ///< Of a higher rating; computed with as its natural logarithm.
  points,      ///< Of a rating, method less reference.
};

inline const char* name_of(EffectScale scale) {
  return scale == EffectScale::ratio        ? "ratio"
         : scale == EffectScale::odds_ratio ? "odds ratio"
                                            : "points";
}

/// A number that was computed with, as a ratio or in points.
inline double in_scale(EffectScale scale, double computed) {
  return scale == EffectScale::points ? computed : std::exp(computed);
}
inline Interval in_scale(EffectScale scale, const Interval& computed) {
  return {in_scale(scale, computed.low), in_scale(scale, computed.high)};
}

}  // namespace foveola::analysis
