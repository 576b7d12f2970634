#include "renderer/scene/textures/texels.h"

#include <cassert>
#include <utility>

namespace foveola {

Texels::Texels(DecodedImage image, bool is_srgb, bool with_mips, bool has_opacity)
    : codes_(std::move(image.texels)),
      channels_(image.channels),
      is_srgb_(is_srgb),
      has_opacity_(has_opacity && image.channels % 2 == 0) {
  assert(image.width > 0 && image.height > 0 && channels_ >= 1 && channels_ <= 4);
  assert(codes_.size() == static_cast<std::size_t>(channels_) * image.width * image.height);
  if (with_mips) {
    levels_ = append_mip_chain(codes_, image.width, image.height, channels_, is_srgb, has_opacity_);
  } else {
    levels_ = {{.width = image.width, .height = image.height, .offset = 0}};
  }
}

std::size_t Texels::memory_bytes() const {
  return sizeof *this + codes_.capacity() + levels_.capacity() * sizeof(MipLevel);
}

}  // namespace foveola
