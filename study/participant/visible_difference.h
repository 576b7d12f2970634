// How much two images differ to an eye: patches of pixels, counted by their share of visual cortex.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/image/image.h"
#include "renderer/view/viewport.h"

namespace foveola::study {

/// The part of a view that is judged, cut into square patches that the eye sees as one.
struct Region {
  struct Patch {
    std::size_t begin = 0;  ///< [begin, end) in `pixels`
    std::size_t end = 0;
    Vec3 direction{0.0F};  ///< of its middle; unit length, world
  };
  std::vector<std::size_t> pixels;  ///< indices into the image, patch after patch
  std::vector<Patch> patches;
};

/// The pixels of a view of width x height within radius_deg of `center`, in patches about patch_deg
/// wide, but not less than a pixel. Empty if the view does not show `center`.
Region region_around(const Viewport& viewport, int width, int height, const Vec3& center,
                     double radius_deg, double patch_deg);

/// The whole view, pixel by pixel.
Region whole_view(const Viewport& viewport, int width, int height);

/// How patches count: by the areal cortical magnification (half_magnification_deg / (e +
/// half_magnification_deg))^2 at their eccentricity e from `gaze` (Dougherty et al. 2003).
struct Eye {
  Vec3 gaze{0.0F, 0.0F, -1.0F};
  double half_magnification_deg = 3.67;
};

/// The root of the weighted mean square difference of the patches' mean colours, in the images'
/// units; infinite for an empty region.
double visible_difference(const RgbImage& presented, const RgbImage& expected, const Region& region,
                          const Eye& eye);

/// The weighted standard deviation of the patches' mean colours; 0 for an empty region.
double visible_contrast(const RgbImage& image, const Region& region, const Eye& eye);

}  // namespace foveola::study
