#include "renderer/scene/gltf/container.h"

#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "renderer/scene/gltf/fault.h"

namespace foveola {
namespace {

constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t little_endian_32(std::string_view content, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, content.data() + offset, sizeof value);
  return value;
}

/// A chunk's content, and where the next one begins.
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

}  // namespace

bool is_gltf_binary(std::string_view content) { return content.starts_with("glTF"); }

GltfParts gltf_parts(std::string_view content) {
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
  GltfParts parts{.json = first.content, .binary = {}};
  if (first.end < file.size()) {
    const Chunk second = chunk_at(file, first.end);
    parts.binary = second.type == binary_type ? second.content : std::string_view();
  }
  return parts;
}

}  // namespace foveola
