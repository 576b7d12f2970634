#include "renderer/scene/gltf/textures.h"

#include <exception>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/files/digest.h"
#include "renderer/scene/gltf/fault.h"
#include "renderer/scene/gltf/values.h"
#include "renderer/scene/textures/decoded_memory.h"
#include "renderer/scene/textures/image_channels.h"
#include "renderer/scene/textures/image_decoder.h"

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

std::string text_of(const GltfFault& fault) {
  return fmt::format("{} {}", fault.where(), fault.what());
}

/// The same of what texels_of() threw.
std::string text_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const GltfFault& fault) {
    return text_of(fault);
  }
}

}  // namespace

int TextureSet::add(int texture, Encoding encoding) {
  return add(texture, Content{.image = -1, .encoding = encoding});
}

int TextureSet::add_glossiness(int texture, float factor) {
  return add(texture,
             Content{.image = -1, .encoding = Encoding::glossiness, .glossiness_factor = factor});
}

/// content: but for its image.
int TextureSet::add(int texture, Content content) {
  if (texture < 0) {
    return -1;
  }
  try {
    content.image = load(texture);
  } catch (const GltfFault& fault) {
    if (is_strict_) {
      throw;
    }
    warn_of_lost_texture(text_of(fault), {}, warnings_);
    return -1;
  }
  const int sampler = model_.textures[static_cast<std::size_t>(texture)].sampler;
  return textures_.add(
      content,
      sampler < 0 ? Sampler() : sampler_of(model_.samplers[static_cast<std::size_t>(sampler)]));
}

/// Reads the encoded image of a texture, and returns its number.
int TextureSet::load(int texture) {
  const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(texture)];
  const int image =
      GltfValues(source.extensions, "EXT_texture_webp").integer("source", source.source);
  if (image < 0) {
    throw GltfFault(fmt::format("textures[{}]", texture),
                    source.extensions.contains("KHR_texture_basisu")
                        ? "has its image in KTX2 alone (KHR_texture_basisu), which is not read: "
                          "export it as PNG or JPEG"
                        : "has no source image");
  }
  images_.load(image);
  foreign_.add(images_.reference_of(image), warnings_);
  return image;
}

std::vector<Texture> TextureSet::decode(std::vector<Material>& materials) const {
  require_modest_size();
  DecodedTextures decoded = textures_.decode([this](const Content& content, bool with_mips) {
    return shared_texels_of(content, with_mips);
  });
  if (is_strict_) {
    rethrow_fault(decoded.faults);
  }
  std::set<int> lost_images;
  for (std::size_t i = 0; i < decoded.faults.size(); ++i) {
    if (decoded.faults[i] && lost_images.insert(textures_.contents()[i].image).second) {
      warn_of_lost_texture(text_of(decoded.faults[i]), {}, warnings_);
    }
  }
  renumber_textures(materials, decoded);
  return std::move(decoded.textures);
}

std::shared_ptr<const Texels> TextureSet::shared_texels_of(const Content& content,
                                                           bool with_mips) const {
  return kept_or_made(
      kept_, [&] { return digest_of(content, with_mips); },
      [&] { return texels_of(content, with_mips); });
}

/// Of all that its texels are made of.
std::string TextureSet::digest_of(const Content& content, bool with_mips) const {
  Sha256 digest;
  const std::string how = fmt::format("{} {} {}", static_cast<int>(content.encoding),
                                      content.glossiness_factor, with_mips);
  digest.update(std::as_bytes(std::span(how)));
  digest.update(std::as_bytes(images_.encoded(content.image)));
  return digest.hex();
}

/// 0 for an image whose header cannot be read: decoding it will say why.
std::size_t TextureSet::decoded_bytes(const Content& content) const {
  try {
    const ImageSize size = size_of_image(images_.encoded(content.image));
    return content.encoding == Encoding::glossiness ? 3 * size.pixels() : size.bytes();
  } catch (const std::runtime_error&) {
    return 0;
  }
}

void TextureSet::require_modest_size() const {
  std::size_t bytes = 0;
  for (const Content& content : textures_.contents()) {
    bytes += decoded_bytes(content);
  }
  try {
    require_modest_memory(bytes, images_.encoded_bytes());
  } catch (const std::runtime_error& refusal) {
    throw GltfFault("images", refusal.what());
  }
}

Texels TextureSet::texels_of(const Content& content, bool with_mips) const {
  try {
    DecodedImage image = decode_image(images_.encoded(content.image));
    if (content.encoding == Encoding::glossiness) {
      image = roughness_of_glossiness(image, content.glossiness_factor);
    }
    const bool has_opacity = content.encoding == Encoding::srgb_opacity;
    return {std::move(image), has_opacity || content.encoding == Encoding::srgb, with_mips,
            has_opacity};
  } catch (const std::runtime_error& error) {
    throw GltfFault(images_.place_of(content.image), error.what());
  }
}

}  // namespace foveola
