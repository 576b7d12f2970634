// FLIP: the difference that a person sees who flips between two images on the same display.
#pragma once

#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// LDR-FLIP of each pixel, row by row, in [0, 1]: 0 for no visible difference (Andersson et al.
/// 2020, "FLIP: A Difference Evaluator for Alternating Images"). Both images are what a display
/// shows: sRGB-encoded values in [0, 1], as display_image gives them. pixels_per_degree: of the
/// display before the eye, above zero. Throws Error if the sizes differ or the density makes no
/// sense.
std::vector<float> flip_errors(const RgbImage& image, const RgbImage& reference,
                               double pixels_per_degree);

/// HDR-FLIP of each pixel: the largest LDR-FLIP over exposures that take the reference from its
/// brightest pixel to its median, by the filmic curve (Andersson et al. 2021, "Visualizing Errors
/// in Rendered High Dynamic Range Images"). Both images are linear, finite and not negative, and
/// the reference is not black; throws Error otherwise, and as flip_errors does.
std::vector<float> hdr_flip_errors(const RgbImage& image, const RgbImage& reference,
                                   double pixels_per_degree);

/// Pixels per degree in the middle of a flat display: `width` pixels over a field of view in (0,
/// pi) radians.
double pixels_per_degree(double fov_rad, int width);

}  // namespace foveola
