// Pictures that show nothing, and which option mends them.
#pragma once

#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// A line if nearly all of an image's pixels that have samples are black, or nearly all white, once
/// they are shown with 8 bits after an exposure of so many stops. is_enclosed: no light comes in
/// from outside the scene.
std::vector<std::string> picture_faults(const FilmImage& image, double exposure_stops,
                                        bool is_enclosed);

}  // namespace foveola
