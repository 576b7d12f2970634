// What a pixel of a view shows of a pyramid over the sphere: the one place that works it out.
#pragma once

#include <span>

#include "renderer/base/lanes.h"
#include "renderer/film/premultiplied_texel.h"
#include "renderer/film/sphere_planes.h"

namespace foveola {

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
inline constexpr std::size_t most_view_points = 8;

/// For each group of eight pixels, the trilinear mean of the cells around each pixel, over that of
/// the cells' weights; what is not known is black, or filled. Linear radiance. As many `colors` as
/// `points`: up to most_view_points, for which memory is asked before the first are worked out.
void shown_colors(const SpherePlanes<PremultipliedTexel>& cells, std::span<const ViewPoints> points,
                  UnsampledPixels unsampled, std::span<Vec3s> colors);

}  // namespace foveola
