// The parts of the sphere inside which errors are measured.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/measure/region_error.h"
#include "renderer/view/viewport.h"

namespace foveola::analysis {

struct Region {
  std::string name;
  /// The weight of a direction (unit length) per steradian: 0 outside, 1 inside, or in between.
  std::function<double(const Vec3&)> weight;
  bool is_in_view = false;  ///< the display shows all of it
};

/// Discs of 2, 5, 10 and 20 degrees' radius around the gaze ("2deg" ... "20deg"), the viewport, the
/// viewport weighted by Reddy's visual acuity ("acuity"), and the whole sphere.
std::vector<Region> regions_around(const Vec3& gaze, const Viewport& viewport);

/// The pixels of an equirect film whose middles lie in the region, weighted by their steradians.
PixelRegion region_on_film(const Region& region, const IVec2& size);

/// The region's pixels on a display of size x size pixels that shows `viewport`, weighted by their
/// steradians.
PixelRegion region_on_view(const Region& region, const Viewport& viewport, int size);

}  // namespace foveola::analysis
