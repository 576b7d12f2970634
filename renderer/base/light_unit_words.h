// The names of the units of a glTF file's lights, in descriptors and on the command line.
#pragma once

#include <array>

#include "renderer/base/scene_source.h"
#include "renderer/base/words.h"

namespace foveola {

inline constexpr std::array light_unit_words{
    Word<LightUnits>{"photometric", LightUnits::photometric},
    Word<LightUnits>{"radiometric", LightUnits::radiometric}};

}  // namespace foveola
