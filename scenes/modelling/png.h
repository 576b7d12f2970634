// Textures as PNG, the form in which a .glb carries them.
#pragma once

#include <cstddef>
#include <vector>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// The image as a PNG file: RGB where every pixel is opaque, else RGBA.
std::vector<std::byte> png_from(const Image& image);

}  // namespace foveola::scenes
