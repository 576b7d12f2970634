// The numbers from which a scene's random things are made, all of which derive from the scene's.
#pragma once

#include <cstdint>

#include "renderer/base/random.h"

namespace foveola::scenes {

/// The seed of one random thing: a texture, a plant, a shelf of books. It is a type of its own, so
/// that no number can be made up where the scene's is wanted: Model::stream gives them.
class Seed {
 public:
  explicit constexpr Seed(std::uint32_t bits) : bits_(bits) {}
  constexpr std::uint32_t bits() const { return bits_; }

 private:
  std::uint32_t bits_;
};

using foveola::mix;

/// The seed of a part of the thing.
constexpr Seed mix(const Seed& seed, std::uint32_t part) { return Seed(mix(seed.bits(), part)); }

inline Pcg32 generator(const Seed& seed) { return Pcg32(seed.bits()); }

}  // namespace foveola::scenes
