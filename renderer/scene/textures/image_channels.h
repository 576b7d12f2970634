// One image out of the channels of two.
#pragma once

#include <optional>

#include "renderer/scene/textures/image_decoder.h"

namespace foveola {

/// `color`, or white without one, with an alpha from `mask`: its own alpha where that is not 255
/// all over, else its grey or red. As large as the one of the two with more pixels, the other's
/// texels repeated or left out. Two channels if `color` is missing or grey, else four.
DecodedImage with_alpha(const std::optional<DecodedImage>& color, const DecodedImage& mask);

/// Roughness in green and metalness in blue, from the greys or reds of the two; 255 for what is
/// missing. As large as with_alpha() would be; one of the two must be there.
DecodedImage roughness_metallic(const std::optional<DecodedImage>& roughness,
                                const std::optional<DecodedImage>& metallic);

/// Roughness in green, 1 - `factor` times the glossiness in the alpha of `image`, which is 1 where
/// it has none; 255 in red and blue. factor: in [0, 1].
DecodedImage roughness_of_glossiness(const DecodedImage& image, float factor);

}  // namespace foveola
