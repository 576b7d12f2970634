// Derives independent random streams from one simulated participant's seed.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

#include "renderer/base/numbers/random.h"

namespace foveola::study {

/// The purpose of a draw; each has streams of its own.
enum class Chance : std::uint32_t {
  traits = 1,
  answers,
  choices,
  reactions,
  path,
  conduct,
  glances,
  ratings,
  injected_person,
  injected_scene,
  injected_trial,
  injected_dropout,
  injected_rating_person,
  injected_rating_trial,
};

/// Returns a hash of a text, the same on every platform.
inline std::uint32_t key_of(const std::string& text) {
  std::uint32_t key = 0;
  for (const char character : text) {
    key = mix(key, static_cast<unsigned char>(character));
  }
  return key;
}

/// Returns the stream for `purpose` at `place`, such as {attempt, glance}: a function of these
/// alone.
inline Pcg32 chance(std::uint64_t seed, Chance purpose,
                    std::initializer_list<std::uint32_t> place = {}) {
  std::uint32_t low = mix(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(purpose));
  std::uint32_t high = mix(static_cast<std::uint32_t>(seed >> 32U), ~low);
  for (const std::uint32_t index : place) {
    low = mix(low, index);
    high = mix(high, ~index);
  }
  return Pcg32(std::uint64_t{high} << 32U | low);
}

}  // namespace foveola::study
