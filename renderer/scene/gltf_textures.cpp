#include "renderer/scene/gltf_textures.h"

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/digest.h"
#include "renderer/scene/decoded_memory.h"
#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/image_decoder.h"

namespace foveola {
namespace {

Wrap wrap_of(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clamp_to_edge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirrored_repeat;
    default:
      return Wrap::repeat;
  }
}

/// A filter that is not stated, -1, is the best there is (specification, section 3.8.4.1).
void read_minification(int filter, Sampler& sampler) {
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
      sampler.minification = Filter::nearest;
      break;
    default:
      sampler.minification = Filter::linear;
  }
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
      sampler.mip = MipFilter::none;
      break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
      sampler.mip = MipFilter::nearest;
      break;
    default:
      sampler.mip = MipFilter::linear;
  }
}

Sampler sampler_of(const tinygltf::Sampler& source) {
  Sampler sampler{.wrap_u = wrap_of(source.wrapS), .wrap_v = wrap_of(source.wrapT)};
  if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) {
    sampler.magnification = Filter::nearest;
  }
  read_minification(source.minFilter, sampler);
  return sampler;
}

/// Calls `work`; what is wrong with the image becomes a fault that names it.
template <typename Work>
auto with_place(int image, Work work) {
  try {
    return work();
  } catch (const std::runtime_error& error) {
    throw GltfFault(fmt::format("images[{}]", image), error.what());
  }
}

}  // namespace

int TextureSet::add(int texture, Encoding encoding) {
  if (texture < 0) {
    return -1;
  }
  const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(texture)];
  if (source.source < 0) {
    throw GltfFault(fmt::format("textures[{}]", texture), "has no source image");
  }
  images_.load(source.source);
  const Sampler sampler =
      source.sampler < 0 ? Sampler()
                         : sampler_of(model_.samplers[static_cast<std::size_t>(source.sampler)]);
  return textures_.add({.image = source.source, .encoding = encoding}, sampler);
}

std::vector<Texture> TextureSet::decode() const {
  require_modest_size();
  return textures_.decode([this](const Content& content, bool with_mips) {
    return shared_texels_of(content, with_mips);
  });
}

std::shared_ptr<const Texels> TextureSet::shared_texels_of(const Content& content,
                                                           bool with_mips) const {
  if (kept_ == nullptr) {
    return std::make_shared<const Texels>(texels_of(content, with_mips));
  }
  Sha256 digest;
  const std::array<bool, 2> how = {content.encoding == Encoding::srgb, with_mips};
  digest.update(std::as_bytes(std::span(how)));
  digest.update(std::as_bytes(images_.encoded(content.image)));
  const std::string name = digest.hex();
  std::shared_ptr<const Texels> texels = kept_->find(name);
  if (texels == nullptr) {
    texels = std::make_shared<const Texels>(texels_of(content, with_mips));
    kept_->keep(name, texels);
  }
  return texels;
}

void TextureSet::require_modest_size() const {
  std::size_t bytes = 0;
  for (const Content& content : textures_.contents()) {
    bytes += with_place(content.image,
                        [&] { return size_of_image(images_.encoded(content.image)).bytes(); });
  }
  try {
    require_modest_memory(bytes, images_.encoded_bytes());
  } catch (const std::runtime_error& refusal) {
    throw GltfFault("images", refusal.what());
  }
}

Texels TextureSet::texels_of(const Content& content, bool with_mips) const {
  DecodedImage image =
      with_place(content.image, [&] { return decode_image(images_.encoded(content.image)); });
  return {std::move(image), content.encoding == Encoding::srgb, with_mips};
}

}  // namespace foveola
