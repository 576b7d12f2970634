// One seed for a whole study, and from it an independent one for everything drawn at random.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "renderer/base/random.h"

namespace foveola::study {

/// What a seed is for; keeps the streams apart.
enum class SeedPurpose : std::uint32_t { participant = 1, tracker = 2, rendering = 3 };

/// The seed for `purpose` at `place`, such as {participant, scene, method, attempt}.
inline std::uint32_t derive_seed(std::uint64_t study_seed, SeedPurpose purpose,
                                 std::initializer_list<int> place) {
  std::uint32_t seed = mix(static_cast<std::uint32_t>(study_seed));
  seed = mix(seed, static_cast<std::uint32_t>(study_seed >> 32));
  seed = mix(seed, static_cast<std::uint32_t>(purpose));
  for (const int index : place) {
    seed = mix(seed, static_cast<std::uint32_t>(index));
  }
  return seed;
}

}  // namespace foveola::study
