// Hides the alpha of a WebP image from decoders that multiply its colours by it.
#pragma once

#include <span>
#include <vector>

namespace foveola {

/// The file `encoded` without its alpha: the same colours, also of invisible pixels, where it is no
/// animation (RFC 9649, sections 2.7 and 3.4).
std::vector<unsigned char> without_webp_alpha(std::span<const unsigned char> encoded);

}  // namespace foveola
