// Which four cells of a pyramid's level lie around a point, for eight points at a time.
#pragma once

#include "renderer/base/lanes.h"

namespace foveola {

/// 2^exponent, for exponents in [-126, 127].
inline Floats power_of_two(const Ints& exponent) {
  return reinterpret_cast<Floats>((127 + exponent) << 23);
}

/// The next integer downwards, of |x| < 2^31.
inline Ints rounded_down(const Floats& x) {
  const Ints towards_zero = truncated(x);
  return towards_zero + (x < floats_of(towards_zero));  // of a mask, "all bits" is -1
}

/// Two by two cells: the upper left one's column and row, each -1 or more, and how far the point
/// lies beyond that one's middle, in cells.
struct CellsAround {
  Ints x, y;
  Floats right, down;
};

/// The cells around points of an equirect image, u in [0, 1) and v in [0, 1], whose level 0 has
/// `size` cells. The
/// four of a level lie within the four of the next one, if that divides the image without a rest.
inline CellsAround cells_around(const Vec2& size, const Vec2s& image, const Ints& level) {
  const Floats per_pixel = power_of_two(-level);
  // The last cells may reach beyond the image's sides.
  const Floats x = image.x * (size.x * per_pixel) - 0.5F;
  const Floats y = image.y * (size.y * per_pixel) - 0.5F;
  const Ints left = rounded_down(x);
  const Ints top = rounded_down(y);
  return {left, top, x - floats_of(left), y - floats_of(top)};
}

}  // namespace foveola
