#include "renderer/scene/obj_textures.h"

#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/image_channels.h"
#include "renderer/scene/image_decoder.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

/// Calls `work` with the file's bytes; what is wrong with the image becomes an Error that names it.
template <typename Work>
auto with_image(const fs::path& file, Work work) {
  const std::string bytes = read_file(file);
  try {
    return work(std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
  } catch (const std::runtime_error& fault) {
    throw Error(file.string(), fault.what(), "convert it to PNG or JPEG");
  }
}

std::optional<DecodedImage> decode(const fs::path& file) {
  return file.empty() ? std::nullopt : std::optional(with_image(file, decode_image));
}

DecodedImage content_of(const ObjTexture& texture) {
  switch (texture.content) {
    case ObjTexture::Content::color_alpha:
      return with_alpha(decode(texture.first), decode(texture.second).value());
    case ObjTexture::Content::roughness_metallic:
      return roughness_metallic(decode(texture.first), decode(texture.second));
    case ObjTexture::Content::plain:
      break;
  }
  return decode(texture.first).value();
}

}  // namespace

int ObjTextureSet::add(const ObjTexture& texture, Wrap wrap) {
  return textures_.add(texture, {.wrap_u = wrap, .wrap_v = wrap});
}

std::vector<Texture> ObjTextureSet::decode() const {
  require_modest_size();
  return textures_.decode([](const ObjTexture& texture, bool with_mips) {
    return Texels(content_of(texture), texture.is_srgb, with_mips);
  });
}

std::set<fs::path> ObjTextureSet::files() const {
  std::set<fs::path> files;
  for (const ObjTexture& texture : textures_.contents()) {
    files.insert({texture.first, texture.second});
  }
  files.erase(fs::path());
  return files;
}

void ObjTextureSet::require_modest_size() const {
  constexpr std::size_t most_pixels = std::size_t{1} << 29;
  std::size_t pixels = 0;
  for (const ObjTexture& texture : textures_.contents()) {
    for (const fs::path& file : {texture.first, texture.second}) {
      if (file.empty()) {
        continue;
      }
      pixels += with_image(file, pixel_count);
      if (pixels > most_pixels) {
        throw Error(file.string(),
                    fmt::format("brings the scene's textures to more than {} pixels", most_pixels),
                    "use smaller images");
      }
    }
  }
}

}  // namespace foveola
