// Textures of the arcade.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes::arcade {

/// Cut limestone: clouds, pores and darker streaks where rain has run. Repeats.
Image weathered_stone(int size, const Rgb& color, const Seed& seed);

/// A banner of brocade: a border, a field of lozenges, a medallion with a star. Not for repeating.
Image banner_cloth(int size, const Rgb& ground, const Seed& seed);

}  // namespace foveola::scenes::arcade
