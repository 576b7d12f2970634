// FLIP: the visible difference when flipping between two images on the same display.
#pragma once

#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// LDR-FLIP of each pixel, row by row, in [0, 1]: 0 for no visible difference (Andersson et al.
/// 2020, "FLIP: A Difference Evaluator for Alternating Images"). Both images are display values:
/// sRGB-encoded in [0, 1], as from display_image. pixels_per_degree: of the display before the eye,
/// positive. Throws Error if the sizes differ or the density is invalid.
std::vector<float> flip_errors(const RgbImage& image, const RgbImage& reference,
                               double pixels_per_degree);

/// HDR-FLIP of each pixel: the maximum LDR-FLIP over exposures from the reference's brightest pixel
/// to its median, with the filmic curve (Andersson et al. 2021, "Visualizing Errors in Rendered
/// High Dynamic Range Images"). Throws Error unless both images are linear, finite and not
/// negative, and the reference is not black; and as flip_errors does.
std::vector<float> hdr_flip_errors(const RgbImage& image, const RgbImage& reference,
                                   double pixels_per_degree);

/// Pixels per degree in the centre of a flat display: `width` pixels over a field of view in (0,
/// pi) radians.
double pixels_per_degree(double fov_rad, int width);

}  // namespace foveola
