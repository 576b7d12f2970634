// Combines channels of two images into one.
#pragma once

#include <optional>

#include "renderer/scene/textures/image_decoder.h"

namespace foveola {

/// `color`, or white without one, with an alpha from `mask`: its own alpha unless that is 255
/// everywhere, else its grey or red. As large as the image with more pixels; the other is resampled
/// to its nearest texels. Two channels if `color` is missing or grey, else four.
DecodedImage with_alpha(const std::optional<DecodedImage>& color, const DecodedImage& mask);

/// Roughness in green and metalness in blue, from the two images' grey or red; 255 for a missing
/// image. As large as with_alpha() would be. At least one image must be present.
DecodedImage roughness_metallic(const std::optional<DecodedImage>& roughness,
                                const std::optional<DecodedImage>& metallic);

/// Roughness in green, 1 - `factor` times the glossiness in the alpha of `image`, which is 1 where
/// it has none; 255 in red and blue. factor: in [0, 1].
DecodedImage roughness_of_glossiness(const DecodedImage& image, float factor);

}  // namespace foveola
