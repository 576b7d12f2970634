// Builds mip levels of an 8-bit image, for footprints wider than a texel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foveola {

/// The place of one level of an image among its texels.
struct MipLevel {
  int width = 0;
  int height = 0;
  std::size_t offset = 0;  ///< position of its first byte
};

/// Minimum number of texels in a coarser level. The mean of fewer is too imprecise in 8 bits: half
/// a code is a tenth of a dark colour.
inline constexpr std::size_t least_mip_texels = 16;

/// Appends its mip levels to `texels`, an image of 1 to 4 interleaved channels. Returns all levels,
/// the image itself first. Each level has half the sides of the one before, rounded down but not
/// below 1; a texel is the mean over its area (a box, whose borders may cut texels where a side was
/// odd), in linear light, rounded so that the level's mean is that of the one before. is_srgb:
/// whether all channels but the second of two and the fourth of four, which are alpha, are
/// sRGB-encoded. has_opacity: whether alpha is an opacity, which weights the other channels.
std::vector<MipLevel> append_mip_chain(std::vector<std::uint8_t>& texels, int width, int height,
                                       int channels, bool is_srgb, bool has_opacity = false);

}  // namespace foveola
