// Maps linear radiance to display values.
#pragma once

#include <cstdint>

#include "renderer/base/numbers/lanes.h"
#include "renderer/image/image.h"

namespace foveola {

/// The sRGB transfer function (IEC 61966-2-1) of a linear value, clamped to [0, 1] first, within
/// 5e-7. NaN gives 0. Number: float, or Floats. A polynomial in the fourth root, in which the power
/// 1 / 2.4 becomes 5 / 3, interpolates the function at the nine Chebyshev points of its range.
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

/// Tone curve from exposed radiance to display values.
enum class ToneCurve : std::uint8_t {
  plain,  ///< linear, clipped at white
  filmic  ///< see filmic()
};

/// Compresses highlights towards white instead of clipping them, per channel: Narkowicz's fit of
/// the Academy Color Encoding System's curve (ACES Filmic Tone Mapping Curve, 2015), applied to 0.6
/// times the linear value, its own exposure. 0.18 becomes 0.14, and 1 becomes 0.67; negative values
/// and NaN become 0. Number: float, or Floats.
template <typename Number>
Number filmic(const Number& linear) {
  constexpr float exposure = 0.6F;
  constexpr float white_long_since = 1e6F;  // and its square is finite
  const Number x = exposure * smaller(larger(linear, 0.0F), white_long_since);
  return smaller((x * (2.51F * x + 0.03F)) / (x * (2.43F * x + 0.59F) + 0.14F), 1.0F);
}

/// Encodes an already exposed linear value for an sRGB display, in [0, 1]. Number: float, or
/// Floats.
template <typename Number>
Number display_from_linear(const Number& linear, ToneCurve curve) {
  return srgb_from_linear(curve == ToneCurve::filmic ? filmic(linear) : linear);
}

/// The factor on radiance for an exposure.
float exposure_scale(double stops);

/// Applies exposure, the curve and the sRGB transfer function per channel; values in [0, 1].
RgbImage display_image(const RgbImage& linear, double exposure_stops,
                       ToneCurve curve = ToneCurve::plain);

}  // namespace foveola
