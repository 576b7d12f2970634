// The seed of the built-in scenes.
#pragma once

#include <cstdint>

namespace foveola::scenes {

/// Of the scenes that the descriptors describe; any other makes a variant.
constexpr std::uint32_t default_seed = 0;

}  // namespace foveola::scenes
