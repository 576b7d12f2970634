// Parameters of contrast sensitivity as functions of luminance, in castleCSF and FovVideoVDP.
#pragma once

#include <cmath>

namespace foveola {

/// scale (1 + half_cd_m2 / L)^-slope: increases with luminance, saturating at `scale`.
struct SaturatingCurve {
  double scale;
  double half_cd_m2;
  double slope;

  double at(double luminance_cd_m2) const {
    return scale * std::pow(1.0 + half_cd_m2 / luminance_cd_m2, -slope);
  }
};

/// A saturating curve that falls again at high luminance.
struct PeakedCurve {
  SaturatingCurve rise;
  SaturatingCurve fall;  ///< its scale is 1

  double at(double luminance_cd_m2) const {
    return rise.at(luminance_cd_m2) * (1.0 - fall.at(luminance_cd_m2));
  }
};

/// exp(-...) of a parabola over log10 frequency: 10^(-log10^2(frequency / peak) / width).
inline double log_parabola(double frequency, double peak, double width) {
  const double decades = std::log10(frequency / peak);
  return std::pow(10.0, -decades * decades / width);
}

}  // namespace foveola
