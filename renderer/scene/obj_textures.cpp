#include "renderer/scene/obj_textures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/decoded_memory.h"
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
    case ObjTexture::Content::unchanged:
      break;
  }
  return decode(texture.first).value();
}

/// A texture of two images is as large as the larger of them, and has up to four channels.
std::size_t most_bytes_of(const ObjTexture& texture, const std::map<fs::path, ImageSize>& sizes) {
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

int ObjTextureSet::add(const ObjTexture& texture, Wrap wrap) {
  return textures_.add(texture, {.wrap_u = wrap, .wrap_v = wrap});
}

std::vector<Texture> ObjTextureSet::decode(const std::string& place) const {
  require_modest_size(place);
  return textures_.decode([](const ObjTexture& texture, bool with_mips) {
    return std::make_shared<const Texels>(content_of(texture), texture.is_srgb, with_mips);
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

void ObjTextureSet::require_modest_size(const std::string& place) const {
  std::size_t encoded_bytes = 0;
  std::map<fs::path, ImageSize> sizes;
  for (const fs::path& file : files()) {
    encoded_bytes += fs::file_size(file);
    sizes[file] = with_image(file, size_of_image);
  }
  std::size_t decoded_bytes = 0;
  for (const ObjTexture& texture : textures_.contents()) {
    decoded_bytes += most_bytes_of(texture, sizes);
  }
  try {
    require_modest_memory(decoded_bytes, encoded_bytes);
  } catch (const std::runtime_error& refusal) {
    throw Error(place, fmt::format("its textures {}", refusal.what()), "use smaller images");
  }
}

}  // namespace foveola
