// What a pixel of a view shows of a pyramid over the sphere: the one place that works it out.
#pragma once

#include <span>

#include "renderer/base/lanes.h"
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

/// What the display shows where no sample has fallen yet.
enum class UnsampledPixels {
  black,  ///< our reading of Koskela et al. 2018, section 3: they were not reconstructed
  filled  ///< from the finest level of the film's pyramid that knows something there
};

/// Where eight pixels lie on the equirect image, u in [0, 1) and v in [0, 1], and the levels they
/// are read from, in [0, the pyramid's last]: 1.25 is a quarter of level 2 and the rest of level 1.
struct ViewPoints {
  Vec2s image;
  Floats level;
};

/// As many groups of eight pixels as shown_colors takes.
inline constexpr std::size_t max_view_points = 8;

/// For each group of eight pixels, the trilinear mean of the cells around each pixel, over that of
/// the cells' weights; what is not known is black, or filled. Linear radiance. As many `colors` as
/// `points`: up to max_view_points, for which memory is asked before the first are worked out.
void shown_colors(const SpherePlanes<PremultipliedTexel>& cells, std::span<const ViewPoints> points,
                  UnsampledPixels unsampled, std::span<Vec3s> colors);

}  // namespace foveola
