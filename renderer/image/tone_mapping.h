// From linear radiance to what a display shows.
#pragma once

#include "renderer/base/lanes.h"
#include "renderer/image/image.h"

namespace foveola {

/// The sRGB transfer function (IEC 61966-2-1) of a linear value, clamped to [0, 1] first, within
/// 5e-7. NaN gives 0. Number: float, or Floats. The polynomial in the fourth root, in which the
/// power 1 / 2.4 is one of 5 / 3, meets the function at the nine Chebyshev points of its range.
template <typename Number>
Number srgb_from_linear(const Number& linear) {
  constexpr float end_of_line = 0.0031308F;
  const Number x = smaller(larger(linear, 0.0F), 1.0F);  // the comparison is false for NaN
  const Number q = square_root(square_root(x));
  const Number curve =
      -0.0578171868F +
      q * (0.113074739F +
           q * (1.53523068F +
                q * (-1.44030099F +
                     q * (1.86993612F +
                          q * (-1.84681502F +
                               q * (1.21772195F + q * (-0.471950383F + q * 0.0809201425F)))))));
  const Number encoded = chosen(x <= end_of_line, 12.92F * x, smaller(curve, 1.0F));
  return chosen(x < 1.0F, encoded, x);
}
float linear_from_srgb(float encoded);

/// What radiance is multiplied by for an exposure.
float exposure_scale(double stops);

/// Exposure by a power of two, then the sRGB transfer function for each channel; values in [0, 1].
RgbImage display_image(const RgbImage& linear, double exposure_stops);

}  // namespace foveola
