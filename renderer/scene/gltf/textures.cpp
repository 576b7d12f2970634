#include "renderer/scene/gltf/textures.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_file/values.h"
#include "renderer/scene/prepare/sanitised.h"
#include "renderer/scene/textures/decoded_memory.h"
#include "renderer/scene/textures/image_channels.h"
#include "renderer/scene/textures/image_decoder.h"

namespace foveola {
namespace {

// The specification's numbers.
constexpr int gl_nearest = 9728;
constexpr int gl_linear = 9729;
constexpr int gl_nearest_mipmap_nearest = 9984;
constexpr int gl_linear_mipmap_nearest = 9985;
constexpr int gl_nearest_mipmap_linear = 9986;
constexpr int gl_clamp_to_edge = 33071;
constexpr int gl_mirrored_repeat = 33648;

Wrap wrap_of(int mode) {
  return mode == gl_clamp_to_edge     ? Wrap::clamp_to_edge
         : mode == gl_mirrored_repeat ? Wrap::mirrored_repeat
                                      : Wrap::repeat;
}

MipFilter mip_filter_of(int filter) {
  switch (filter) {
    case gl_nearest:
    case gl_linear:
      return MipFilter::none;
    case gl_nearest_mipmap_nearest:
    case gl_linear_mipmap_nearest:
      return MipFilter::nearest;
    default:
      return MipFilter::linear;
  }
}

/// An unstated filter is the best one (specification, section 3.8.4.1).
Sampler sampler_of(const GltfValues& source) {
  const int minification = source.integer("minFilter");
  const bool is_nearest = minification == gl_nearest || minification == gl_nearest_mipmap_nearest ||
                          minification == gl_nearest_mipmap_linear;
  return {
      .wrap_u = wrap_of(source.integer("wrapS")),
      .wrap_v = wrap_of(source.integer("wrapT")),
      .magnification = source.integer("magFilter") == gl_nearest ? Filter::nearest : Filter::linear,
      .minification = is_nearest ? Filter::nearest : Filter::linear,
      .mip = mip_filter_of(minification)};
}

/// fault: a GltfFault.
std::string text_of_gltf_fault(const std::runtime_error& fault) {
  return fmt::format("{} {}", dynamic_cast<const GltfFault&>(fault).where(), fault.what());
}

std::span<const unsigned char> bytes_of(const std::string& content) {
  return {reinterpret_cast<const unsigned char*>(content.data()), content.size()};
}

}  // namespace

void GltfImages::load(int image) {
  if (!loaded_.insert(image).second) {
    return;
  }
  const GltfImage& source = file_.model.images[static_cast<std::size_t>(image)];
  if (source.view >= 0) {
    const std::size_t buffer = file_.model.views[static_cast<std::size_t>(source.view)].buffer;
    if (buffers_.insert(buffer).second) {
      encoded_bytes_ += file_.model.buffers[buffer].size();
    }
  } else if (!source.content.empty()) {
    encoded_bytes_ += source.content.size();
  } else {
    try {
      if (!confined_file_if_there(file_.folder, source.uri)) {
        missing_files_.insert(file_.folder / local_reference(reference_of(image)));
      }
      load_file(image, confined_file(file_.folder, source.uri));
    } catch (const std::runtime_error& refusal) {
      throw GltfFault(fmt::format("images[{}].uri", image), refusal.what());
    }
  }
}

std::string GltfImages::reference_of(int image) const {
  return percent_decoded(file_.model.images[static_cast<std::size_t>(image)].uri);
}

void GltfImages::load_file(int image, const std::filesystem::path& path) {
  if (!contents_.contains(path)) {
    contents_[path] = read_file(path);
    encoded_bytes_ += contents_[path].size();
  }
  paths_[image] = path;
}

std::span<const unsigned char> GltfImages::encoded(int image) const {
  const GltfImage& source = file_.model.images[static_cast<std::size_t>(image)];
  if (source.view >= 0) {
    const GltfBufferView& view = file_.model.views[static_cast<std::size_t>(source.view)];
    return std::span(file_.model.buffers[view.buffer]).subspan(view.offset, view.length);
  }
  return source.content.empty() ? bytes_of(contents_.at(paths_.at(image))) : source.content;
}

std::string GltfImages::place_of(int image) const {
  const auto path = paths_.find(image);
  const std::string file =
      path == paths_.end() ? "" : fmt::format(" ({})", sanitised(path->second.filename().string()));
  return fmt::format("images[{}]{}", image, file);
}

FileHashes GltfImages::hashes() const {
  FileHashes hashes;
  for (const auto& [path, content] : contents_) {
    hashes[path] = sha256(std::string_view(content));
  }
  return hashes;
}

int TextureSet::add(int texture, Encoding encoding) {
  return add(texture, Content{.image = -1, .encoding = encoding});
}

int TextureSet::add_glossiness(int texture, float factor) {
  return add(texture,
             Content{.image = -1, .encoding = Encoding::glossiness, .glossiness_factor = factor});
}

/// content: complete except for its image.
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
    warn_of_lost_texture(text_of_gltf_fault(fault), {}, warnings_);
    return -1;
  }
  const int sampler = texture_at(texture).integer("sampler");
  return textures_.add(content, sampler < 0 ? Sampler()
                                            : sampler_of(model_.root().item(
                                                  "samplers", static_cast<std::size_t>(sampler))));
}

GltfValues TextureSet::texture_at(int texture) const {
  return model_.root().item("textures", static_cast<std::size_t>(texture));
}

/// Reads the encoded image of a texture, and returns its number.
int TextureSet::load(int texture) {
  const GltfValues source = texture_at(texture);
  const int image =
      source.extension("EXT_texture_webp").integer("source", source.integer("source"));
  if (image < 0) {
    throw GltfFault(fmt::format("textures[{}]", texture),
                    source.extension("KHR_texture_basisu").exists()
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
  return take_textures(std::move(decoded), materials, is_strict_, text_of_gltf_fault, warnings_);
}

std::shared_ptr<const Texels> TextureSet::shared_texels_of(const Content& content,
                                                           bool with_mips) const {
  return kept_or_made(
      kept_, [&] { return digest_of(content, with_mips); },
      [&] { return texels_of(content, with_mips); });
}

/// Of all inputs of its texels.
std::string TextureSet::digest_of(const Content& content, bool with_mips) const {
  Sha256 digest;
  const std::string how = fmt::format("{} {} {}", static_cast<int>(content.encoding),
                                      content.glossiness_factor, with_mips);
  digest.update(std::as_bytes(std::span(how)));
  digest.update(std::as_bytes(images_.encoded(content.image)));
  return digest.hex();
}

/// 0 for an unreadable header: decoding will report it.
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
