// Sine, cosine and arctangent of angles in turns. Full turns are exact, without a rounded pi; free
// of branches and calls, they can be vectorised.
#pragma once

#include <cmath>
#include <numbers>

#include "renderer/base/numbers/lanes.h"

namespace foveola {

/// An angle's sine and cosine. Number: float, or Floats.
template <typename Number>
struct SinesCosines {
  Number sine;
  Number cosine;
};
using SineCosine = SinesCosines<float>;

/// Sine and cosine of the angle 2 pi `turns`, for |turns| < 2^20, within 1e-7. The polynomials for
/// an eighth of a turn are those of Moshier's Cephes library (sinf, cosf), 1992. Number: float, or
/// Floats. Declared inline: otherwise GCC inlines fewer of these templates, and a loop that calls
/// one is not vectorised.
template <typename Number>
inline SinesCosines<Number> sine_cosine_of_turns(const Number& turns) {
  constexpr float radians_per_turn = 6.28318530717958648F;
  const Number quarters = nearest_integer(4.0F * turns);
  const Number x = (turns - 0.25F * quarters) * radians_per_turn;
  const Number z = x * x;
  const Number sine =
      x + x * z * (-1.6666654611e-1F + z * (8.3321608736e-3F + z * -1.9515295891e-4F));
  const Number cosine =
      1.0F - 0.5F * z +
      z * z * (4.166664568298827e-2F + z * (-1.388731625493765e-3F + z * 2.443315711809948e-5F));
  const auto quadrant = truncated(quarters);
  const auto is_odd = (quadrant & 1) != 0;
  const Number first = chosen(is_odd, cosine, sine);
  const Number second = chosen(is_odd, sine, cosine);
  return {.sine = chosen((quadrant & 2) != 0, -first, first),
          .cosine = chosen(((quadrant + 1) & 2) != 0, -second, second)};
}

/// Sine and cosine of an azimuth in turns, in [0, 1]. Single numbers use the library's functions;
/// lanes use polynomials, since the library has no functions for lanes.
inline SineCosine azimuth_at(float turns) {
  const float radians = 2.0F * std::numbers::pi_v<float> * turns;
  return {.sine = std::sin(radians), .cosine = std::cos(radians)};
}
inline SinesCosines<Floats> azimuth_at(const Floats& turns) { return sine_cosine_of_turns(turns); }

/// The angle of (x, y) from the x axis towards y, in [-0.5, 0.5] turns, within 4e-8; 0 for (0,
/// 0). The polynomial is that of Moshier's Cephes library (atanf), 1992. Number: float, or Floats.
template <typename Number>
inline Number turns_of(const Number& y, const Number& x) {
  constexpr float turns_per_radian = 0.159154943091895336F;
  constexpr float tan_of_sixteenth = 0.414213562373095049F;
  const Number across = magnitude(x);
  const Number up = magnitude(y);
  const auto is_steep = across < up;
  const Number shorter = chosen(is_steep, across, up);
  const Number longer = chosen(is_steep, up, across);
  const Number ratio = shorter / chosen(longer > 0.0F, longer, Number{} + 1.0F);
  // tan(a - pi/4) = (tan a - 1) / (tan a + 1).
  const auto is_beyond = ratio > tan_of_sixteenth;
  const Number t = chosen(is_beyond, (ratio - 1.0F) / (ratio + 1.0F), ratio);
  const Number z = t * t;
  const Number radians =
      t + t * z *
              (-3.33329491539e-1F +
               z * (1.99777106478e-1F + z * (-1.38776856032e-1F + z * 8.05374449538e-2F)));
  const Number eighth = chosen(is_beyond, Number{} + 0.125F, Number{});
  const Number within_quarter = radians * turns_per_radian + eighth;
  const Number of_magnitudes = chosen(is_steep, 0.25F - within_quarter, within_quarter);
  return with_sign(chosen(x < 0.0F, 0.5F - of_magnitudes, of_magnitudes), y);
}

}  // namespace foveola
