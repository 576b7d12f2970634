#include "renderer/scene/gltf_file/file.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/gltf_file/data_uri.h"
#include "renderer/scene/gltf_file/document.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_mesh/buffers.h"
#include "renderer/scene/gltf_mesh/compression.h"
#include "renderer/scene/references.h"

namespace foveola {
namespace {

constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;
constexpr std::size_t longest_json = std::size_t{1} << 30;

bool is_gltf_binary(std::string_view content) { return content.starts_with("glTF"); }

std::uint32_t little_endian_32(std::string_view content, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, content.data() + offset, sizeof value);
  return value;
}

/// A chunk's content, and the beginning of the next.
struct Chunk {
  std::uint32_t type = 0;
  std::string_view content;
  std::size_t end = 0;
};

Chunk chunk_at(std::string_view content, std::size_t begin) {
  const std::size_t payload = begin + chunk_header_size;
  const std::size_t end =
      payload <= content.size() ? payload + little_endian_32(content, begin) : payload;
  if (end > content.size()) {
    throw GltfFault("", fmt::format("the chunk at byte {} ends after the file's {} bytes", begin,
                                    content.size()));
  }
  return {.type = little_endian_32(content, begin + 4),
          .content = content.substr(payload, end - payload),
          .end = end};
}

/// The file up to the length that its header gives.
std::string_view announced_part(std::string_view content) {
  if (content.size() < header_size + chunk_header_size) {
    throw GltfFault("", fmt::format("the file is truncated: {} bytes cannot hold a glTF binary",
                                    content.size()));
  }
  if (const std::uint32_t version = little_endian_32(content, 4); version != 2) {
    throw GltfFault("", fmt::format("is glTF binary version {}, not 2", version));
  }
  const std::size_t length = little_endian_32(content, 8);
  if (length > content.size()) {
    throw GltfFault("", fmt::format("the file is truncated: its header announces {} bytes, but "
                                    "there are {}",
                                    length, content.size()));
  }
  return content.substr(0, length);
}

struct Parts {
  std::string_view json;
  std::string_view binary;  ///< content of buffers[0] without a uri; empty if there is none
};

/// The parts of a .glb file (specification, section 4) or of a .gltf file, which is all JSON.
Parts parts_of(std::string_view content) {
  constexpr std::uint32_t json_type = 0x4E4F534A;
  constexpr std::uint32_t binary_type = 0x004E4942;
  if (!is_gltf_binary(content)) {
    return {.json = content, .binary = {}};
  }
  const std::string_view file = announced_part(content);
  const Chunk first = chunk_at(file, header_size);
  if (first.type != json_type) {
    throw GltfFault("", "the first chunk is not JSON");
  }
  Parts parts{.json = first.content, .binary = {}};
  if (first.end < file.size()) {
    const Chunk second = chunk_at(file, first.end);
    parts.binary = second.type == binary_type ? second.content : std::string_view();
  }
  return parts;
}

/// Gives the images in data: uris their content. Missing unused images are harmless, but a scene
/// that names a file outside its folder is not trusted.
void read_embedded_images(std::vector<GltfImage>& images, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    GltfImage& image = images[i];
    if (image.view >= 0) {
      continue;
    }
    const std::string place = fmt::format("images[{}].uri", i);
    if (is_data_uri(image.uri)) {
      const std::optional<std::string> content = bytes_of_data_uri(image.uri);
      if (!content || content->empty()) {
        throw GltfFault(place, "is a data: uri that is not base64");
      }
      image.content.assign(content->begin(), content->end());
      image.uri.clear();
      continue;
    }
    std::optional<std::filesystem::path> file;
    try {
      file = confined_file_if_there(folder, image.uri);
    } catch (const std::runtime_error& refusal) {
      throw GltfFault(place, refusal.what());
    }
    if (file) {
      require_no_output(*file);  // here, since reading a texture would only warn
    }
  }
}

}  // namespace

GltfFile read_gltf_file(const std::filesystem::path& path, std::string& content) {
  read_file(path, content);
  if (!is_gltf_binary(content) && lower_case_extension(path) == ".glb") {
    throw GltfFault("", "is not a glTF binary: it does not begin with \"glTF\"");
  }
  const Parts parts = parts_of(content);
  if (parts.json.size() > longest_json) {
    throw GltfFault("", fmt::format("has {} bytes of JSON; up to {} are read", parts.json.size(),
                                    longest_json));
  }
  GltfFile file{.model = GltfModel(checked_gltf_document(parts.json)),
                .folder = path.has_parent_path() ? path.parent_path() : ".",
                .sha256 = sha256(std::string_view(content)),
                .buffer_hashes = {}};
  read_embedded_images(file.model.images, file.folder);
  file.buffer_hashes = read_gltf_buffers(file.model, parts.binary, file.folder);
  decompress_meshopt(file.model);
  decompress_draco(file.model);
  return file;
}

}  // namespace foveola
