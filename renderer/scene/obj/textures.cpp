#include "renderer/scene/obj/textures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/textures/decoded_memory.h"
#include "renderer/scene/textures/image_channels.h"
#include "renderer/scene/textures/image_decoder.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

/// Calls `work` with the file's bytes; turns the image's faults into an Error that names the file.
template <typename Work>
auto with_image(const fs::path& file, Work work) {
  const std::string bytes = read_file(file);
  try {
    return work(std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
  } catch (const std::runtime_error& fault) {
    throw Error(file.string(), fault.what(), "convert it to PNG");
  }
}

/// All zero for an unreadable header: decoding will report it.
ImageSize size_if_readable(const fs::path& file) {
  try {
    return with_image(file,
                      [](auto bytes) { return size_of_image(bytes, ImageFormats::any_texture); });
  } catch (const OutputIsInput&) {
    throw;
  } catch (const Error&) {
    return {};
  }
}

std::optional<DecodedImage> decode(const fs::path& file, bool is_srgb) {
  if (file.empty()) {
    return std::nullopt;
  }
  return with_image(file, [is_srgb](auto bytes) {
    return decode_image(bytes, ImageFormats::any_texture, is_srgb);
  });
}

DecodedImage content_of(const ObjTexture& texture) {
  switch (texture.content) {
    case ObjTexture::Content::color_alpha:
      return with_alpha(decode(texture.first, texture.is_srgb),
                        decode(texture.second, false).value());
    case ObjTexture::Content::roughness_metallic:
      return roughness_metallic(decode(texture.first, false), decode(texture.second, false));
    case ObjTexture::Content::unchanged:
      break;
  }
  return decode(texture.first, texture.is_srgb).value();
}

/// Of all inputs of its texels.
std::string digest_of(const ObjTexture& texture, bool with_mips) {
  const auto digest_of_file = [](const fs::path& file) {
    return file.empty() ? std::string() : sha256_of_file(file);
  };
  return sha256(fmt::format("OBJ {} {} {} {} {}", static_cast<int>(texture.content),
                            digest_of_file(texture.first), digest_of_file(texture.second),
                            texture.is_srgb, with_mips));
}

/// A texture of two images is as large as the larger of them, and has up to four channels.
std::size_t max_bytes_of(const ObjTexture& texture, const std::map<fs::path, ImageSize>& sizes) {
  if (texture.content == ObjTexture::Content::unchanged) {
    return sizes.at(texture.first).bytes();
  }
  std::size_t pixels = 0;
  for (const fs::path& file : {texture.first, texture.second}) {
    pixels = std::max(pixels, file.empty() ? 0 : sizes.at(file).pixels());
  }
  return 4 * pixels;
}

}  // namespace

bool has_colors(const fs::path& file) {
  constexpr int noise = 8;  // of JPEG's greys
  try {
    const DecodedImage image = decode(file, false).value();
    const auto step = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; step > 2 && i < image.texels.size(); i += step) {
      const auto [low, high] =
          std::minmax({image.texels[i], image.texels[i + 1], image.texels[i + 2]});
      if (high - low > noise) {
        return true;
      }
    }
  } catch (const OutputIsInput&) {
    throw;
  } catch (const Error&) {  // it is left out, like any bump map
  }
  return false;
}

int ObjTextureSet::add(const ObjTexture& texture, Wrap wrap) {
  return textures_.add(texture, {.wrap_u = wrap, .wrap_v = wrap});
}

std::vector<Texture> ObjTextureSet::decode(std::vector<Material>& materials,
                                           KeptParts<Texels>* kept, const std::string& place,
                                           bool is_strict, Warnings& warnings) const {
  require_modest_size(place);
  DecodedTextures decoded = textures_.decode([&](const ObjTexture& texture, bool with_mips) {
    return kept_or_made(
        kept, [&] { return digest_of(texture, with_mips); },
        [&] {
          return Texels(content_of(texture), texture.is_srgb, with_mips,
                        texture.content == ObjTexture::Content::color_alpha);
        });
  });
  return take_textures(
      std::move(decoded), materials, is_strict,
      [](const std::runtime_error& fault) { return std::string(fault.what()); }, warnings);
}

std::set<fs::path> ObjTextureSet::files() const {
  std::set<fs::path> files;
  for (const ObjTexture& texture : textures_.contents()) {
    files.insert({texture.first, texture.second});
  }
  files.erase(fs::path());
  return files;
}

void ObjTextureSet::require_modest_size(const std::string& place) const {
  std::size_t encoded_bytes = 0;
  std::map<fs::path, ImageSize> sizes;
  for (const fs::path& file : files()) {
    encoded_bytes += fs::file_size(file);
    sizes[file] = size_if_readable(file);
  }
  std::size_t decoded_bytes = 0;
  for (const ObjTexture& texture : textures_.contents()) {
    decoded_bytes += max_bytes_of(texture, sizes);
  }
  try {
    require_modest_memory(decoded_bytes, encoded_bytes);
  } catch (const std::runtime_error& refusal) {
    throw Error(place, fmt::format("its textures {}", refusal.what()), "use smaller images");
  }
}

}  // namespace foveola
