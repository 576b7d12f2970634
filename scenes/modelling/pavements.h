// Procedural textures of old floors.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// Worn floor slabs in rows of unequal widths; repeats without a seam.
Image stone_slabs(int size, const Seed& seed);

/// A round pavement of coloured marbles in a square: rings, a star and bands of small triangles.
Image inlaid_rosette(int size, const Seed& seed);

/// Bands of small triangles and squares about a row of discs along u; repeats along u.
Image inlaid_band(int size, const Seed& seed);

}  // namespace foveola::scenes
