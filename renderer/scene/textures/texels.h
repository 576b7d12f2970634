// What a texture shows: an image in 8 bits with its coarser levels, which several textures can
// share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/scene/textures/image_decoder.h"
#include "renderer/scene/textures/mip_chain.h"

namespace foveola {

class Texels {
 public:
  /// is_srgb: whether grey or red, green and blue are sRGB-encoded; alpha never is. with_mips:
  /// whether coarser levels are built, for a third more memory. has_opacity: whether an alpha says
  /// how far a texel is there: the others then count as far as they are.
  Texels(DecodedImage image, bool is_srgb, bool with_mips, bool has_opacity = false);

  /// Levels of `channels()` interleaved bytes a texel, the image itself first.
  const std::vector<MipLevel>& levels() const { return levels_; }
  const std::uint8_t* codes() const { return codes_.data(); }
  int channels() const { return channels_; }
  bool is_srgb() const { return is_srgb_; }
  bool has_opacity() const { return has_opacity_; }

  std::size_t memory_bytes() const;

 private:
  std::vector<MipLevel> levels_;
  std::vector<std::uint8_t> codes_;
  int channels_;
  bool is_srgb_;
  bool has_opacity_;
};

}  // namespace foveola
