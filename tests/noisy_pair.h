// A picture and the same with noise: the pair for which other programs state visible differences.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer/image/image.h"

namespace foveola::test {

struct NoisyPair {
  RgbImage image;
  RgbImage reference;
};

/// Grey levels of 8 bits over 255, of 512 x 512 pixels unless `size` says otherwise. noise: in grey
/// levels. frame: of a sequence whose noise moves; 0 for still pictures.
inline NoisyPair noisy_pair(double noise = 24.0, std::uint32_t frame = 0,
                            const IVec2& size = {512, 512}) {
  NoisyPair pair = {RgbImage(size.x, size.y), RgbImage(size.x, size.y)};
  constexpr double turn = 2.0 * std::numbers::pi;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const double grey =
          std::floor(128.0 + 60.0 * std::sin(turn * x / 64.0) * std::cos(turn * y / 48.0));
      const std::uint32_t hash = ((73856093U * (static_cast<std::uint32_t>(x) + 97U * frame)) ^
                                  (19349663U * (static_cast<std::uint32_t>(y) + 31U * frame))) &
                                 65535U;
      const double random = (hash * 40503U & 65535U) / 65535.0 - 0.5;
      pair.reference.at(x, y) = Rgb(static_cast<float>(grey / 255.0));
      pair.image.at(x, y) = Rgb(
          static_cast<float>(std::floor(std::clamp(grey + noise * random, 0.0, 255.0)) / 255.0));
    }
  }
  return pair;
}

}  // namespace foveola::test
