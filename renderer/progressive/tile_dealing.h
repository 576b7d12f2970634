// Which part of a render that is split by tiles traces a pixel.
#pragma once

#include <cstdint>

#include "renderer/base/vec.h"

namespace foveola {

/// The number in [1, shards] of the part that has `pixel`, the same for all renders. Small tiles
/// are dealt in turn, row by row, and the turn moves by the golden section of a round from row to
/// row: wherever there are many tiles, each part has as many of them, far from one another, so that
/// all trace about as much wherever samples go. shards: in [1, most_shards].
inline std::int64_t shard_of_pixel(const IVec2& pixel, std::int64_t shards) {
  // In pixels. A fovea, which gets a tenth of the samples, has some 50 such tiles in an image of
  // 1024 pixels; larger ones could not be dealt evenly, and smaller ones hardly more so.
  constexpr int tile_side = 4;
  constexpr std::uint32_t golden_section = 0x9E3779B9U;  // times 2^32
  const std::uint32_t column = static_cast<std::uint32_t>(pixel.x) / tile_side;
  const std::uint32_t row = static_cast<std::uint32_t>(pixel.y) / tile_side;
  const auto count = static_cast<std::uint32_t>(shards);
  const std::uint32_t part_of_round = golden_section * row;  // times 2^32, without whole rounds
  const auto first = static_cast<std::uint32_t>((std::uint64_t{part_of_round} * count) >> 32U);
  return 1 + std::int64_t{(first + column) % count};
}

}  // namespace foveola
