// The one place that computes a view pixel's colour from a pyramid over the sphere.
#pragma once

#include <span>

#include "renderer/base/numbers/lanes.h"
#include "renderer/film/sphere_planes.h"
#include "renderer/film/texel_pyramid.h"

namespace foveola {

/// 2^exponent, for exponents in [-126, 127].
inline Floats power_of_two(const Ints& exponent) {
  return reinterpret_cast<Floats>((127 + exponent) << 23);
}

/// The next integer downwards, of |x| < 2^31.
inline Ints rounded_down(const Floats& x) {
  const Ints towards_zero = truncated(x);
  return towards_zero + (x < floats_of(towards_zero));  // a comparison's "all bits" is -1
}

/// Two by two cells: the upper left one's column and row, each -1 or more, and the point's distance
/// from that cell's centre, in cells.
struct CellsAround {
  Ints x, y;
  Floats right, down;
};

/// The cells around points of an equirect image, u in [0, 1) and v in [0, 1], whose level 0 has
/// `size` cells. The four of a level lie within the four of the next one, if that level's cells
/// divide the image.
inline CellsAround cells_around(const Vec2& size, const Vec2s& image, const Ints& level) {
  const Floats per_pixel = power_of_two(-level);
  // The last cells may extend beyond the image.
  const Floats x = image.x * (size.x * per_pixel) - 0.5F;
  const Floats y = image.y * (size.y * per_pixel) - 0.5F;
  const Ints left = rounded_down(x);
  const Ints top = rounded_down(y);
  return {left, top, x - floats_of(left), y - floats_of(top)};
}

/// Display of regions without samples.
enum class UnsampledPixels {
  black,  ///< our reading of Koskela et al. 2018, section 3: not reconstructed
  filled  ///< from the finest non-empty level of the film's pyramid
};

/// The places of eight pixels on the equirect image, u in [0, 1) and v in [0, 1], and their pyramid
/// levels, in [0, last level]: 1.25 is a quarter of level 2 and the rest of level 1.
struct ViewPoints {
  Vec2s image;
  Floats level;
};

/// Maximum number of groups of eight pixels in shown_colors.
inline constexpr std::size_t max_view_points = 8;

/// The weighted trilinear mean of the cells around each pixel, for groups of eight; unknown pixels
/// are black, or filled. Linear radiance. As many `colors` as `points`, up to max_view_points;
/// memory of all is prefetched first.
void shown_colors(const SpherePlanes<PremultipliedTexel>& cells, std::span<const ViewPoints> points,
                  UnsampledPixels unsampled, std::span<Vec3s> colors);

}  // namespace foveola
