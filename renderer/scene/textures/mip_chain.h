// Smaller and smaller averages of an 8-bit image, for footprints that are wider than a texel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foveola {

/// Where one level of an image lies among its texels.
struct MipLevel {
  int width = 0;
  int height = 0;
  std::size_t offset = 0;  ///< position of its first byte
};

/// A coarser level has at least as many texels. The mean of fewer could not be stated exactly
/// enough in 8 bits: half a code is a tenth of a dark colour.
inline constexpr std::size_t least_mip_texels = 16;

/// Appends to `texels`, an image of 1 to 4 interleaved channels, its averages and returns all
/// levels, the image itself first. Each level has half the sides of the one before, rounded down
/// but not below 1; a texel is the mean over its area (a box, whose borders may cut texels where a
/// side was odd), in linear light, rounded so that the level's mean is that of the one before.
/// is_srgb: whether all channels but the second of two and the fourth of four, which are alpha, are
/// sRGB-encoded. has_opacity: whether alpha says how far a texel is there, so that it weights the
/// others.
std::vector<MipLevel> append_mip_chain(std::vector<std::uint8_t>& texels, int width, int height,
                                       int channels, bool is_srgb, bool has_opacity = false);

}  // namespace foveola
