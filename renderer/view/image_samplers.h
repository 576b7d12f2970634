// Samplers without a gaze: uniform over the image, a rectangle of it, or the viewport.
#pragma once

#include <memory>

#include "renderer/view/image_rectangle.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Every pixel of a rectangle of the equirect image alike; OD is the whole image.
std::unique_ptr<ViewSampler> make_rectangle_sampler(const ImageRectangle& rectangle);

/// VP as the rectangle of the image that bounds the viewport.
std::unique_ptr<ViewSampler> make_viewport_rectangle_sampler();

/// VP: every part of the display's plane alike.
std::unique_ptr<ViewSampler> make_viewport_sampler();

}  // namespace foveola
