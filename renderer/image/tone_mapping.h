// From linear radiance to what a display shows.
#pragma once

#include "renderer/image/image.h"

namespace foveola {

/// The sRGB transfer function (IEC 61966-2-1) of a linear value, clamped to [0, 1] first. NaN gives
/// 0.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

/// Exposure by a power of two, then the sRGB transfer function for each channel; values in [0, 1].
RgbImage display_image(const RgbImage& linear, double exposure_stops);

}  // namespace foveola
