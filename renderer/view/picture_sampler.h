// The sampler of an ordinary picture: every part of a flat image alike.
#pragma once

#include <memory>

#include "renderer/view/view_sampler.h"

namespace foveola {

/// Uniform over the plane of the viewport that it is aimed with. A sample's image position is its
/// place in the picture, (0, 0) at the top left, and not on the sphere: films that are made with it
/// are pictures, and nothing may take their pixels for those of a 360-degree image.
std::unique_ptr<ViewSampler> make_picture_sampler();

}  // namespace foveola
