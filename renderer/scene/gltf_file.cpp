#include "renderer/scene/gltf_file.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/confined_file.h"
#include "renderer/scene/gltf_document.h"
#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/sanitised.h"

namespace foveola {
namespace {

constexpr std::string_view glb_magic = "glTF";

/// tinygltf counts the text of a data: uri in an int.
constexpr std::size_t longest_json = std::size_t{1} << 30;

/// Files may be named any number of times, and each time they are read.
constexpr std::uintmax_t largest_total_size = std::uintmax_t{1} << 33;

bool is_glb(std::string_view content) { return content.starts_with(glb_magic); }

std::uint32_t little_endian_32(std::string_view content, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, content.data() + offset, sizeof value);
  return value;
}

/// Checks the GLB header and its first two chunks (specification, section 4), and returns the JSON
/// chunk's content.
std::string_view json_chunk(std::string_view content) {
  constexpr std::size_t header_size = 12;
  constexpr std::size_t chunk_header_size = 8;
  constexpr std::uint32_t json_type = 0x4E4F534A;
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
  const auto chunk_end = [&](std::size_t chunk) {
    const std::size_t payload = chunk + chunk_header_size;
    const std::size_t end =
        payload <= length ? payload + little_endian_32(content, chunk) : payload;
    if (end > length) {
      throw GltfFault(
          "", fmt::format("the chunk at byte {} ends after the file's {} bytes", chunk, length));
    }
    return end;
  };
  const std::size_t json_end = chunk_end(header_size);
  if (little_endian_32(content, header_size + 4) != json_type) {
    throw GltfFault("", "the first chunk is not JSON");
  }
  if (json_end < length) {
    chunk_end(json_end);
  }
  constexpr std::size_t json_begin = header_size + chunk_header_size;
  return content.substr(json_begin, json_end - json_begin);
}

/// tinygltf knows the type image/jpeg only.
bool decode_jpg(const std::string& uri, std::vector<unsigned char>& bytes) {
  std::string type;
  const std::string known = "data:image/jpeg;base64," + uri.substr(jpg_data_uri.size());
  return tinygltf::DecodeDataURI(&bytes, type, known, 0, false);
}

/// What tinygltf asks for, in the order in which it asks, which is the document's.
struct References {
  std::vector<GltfReference> references;
  std::filesystem::path folder;
  std::size_t next = 0;
  std::uintmax_t total_size = 0;
  FileHashes hashes;  ///< SHA-256s of the files that were read
};

/// A scene whose unused images are missing can be shown, but one that names a file outside its
/// folder is not to be trusted.
void require_confined_images(const References& referred) {
  for (const GltfReference& reference : referred.references) {
    if (reference.is_image && !reference.uri.starts_with(jpg_data_uri)) {
      try {
        confined_file_if_there(referred.folder, reference.uri);
      } catch (const std::runtime_error& refusal) {
        throw GltfFault(reference.place, refusal.what());
      }
    }
  }
}

std::string content_of(const GltfReference& reference, References& referred) {
  const std::filesystem::path path = confined_file(referred.folder, reference.uri);
  referred.total_size += std::filesystem::file_size(path);
  if (referred.total_size > largest_total_size) {
    throw std::runtime_error(
        fmt::format("brings the files of the scene to more than {} bytes", largest_total_size));
  }
  std::string content = read_file(path);
  if (content.empty()) {
    throw std::runtime_error("refers to an empty file");
  }
  referred.hashes[path] = sha256(std::string_view(content));
  return content;
}

/// False, which tinygltf takes well, for images in files of their own: they are read if they are
/// used.
bool read_next_reference(std::vector<unsigned char>* bytes, std::string* /*error*/,
                         const std::string& /*name*/, void* user_data) {
  auto& referred = *static_cast<References*>(user_data);
  const GltfReference& reference = referred.references.at(referred.next++);
  if (reference.is_image) {
    return reference.uri.starts_with(jpg_data_uri) && decode_jpg(reference.uri, *bytes);
  }
  try {
    const std::string content = content_of(reference, referred);
    bytes->assign(content.begin(), content.end());
  } catch (const std::runtime_error& error) {
    throw GltfFault(reference.place, error.what());
  }
  return true;
}

/// Hands every file access of tinygltf to `referred`.
tinygltf::FsCallbacks callbacks_into(References& referred) {
  return {.FileExists = [](const std::string&, void*) { return true; },
          .ExpandFilePath = [](const std::string& name, void*) { return name; },
          .ReadWholeFile = read_next_reference,
          .WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                               void*) { return false; },
          .user_data = &referred};
}

/// Keeps the encoded bytes of an image that has no buffer view to keep them.
bool keep_encoded_image(tinygltf::Image* image, const int /*index*/, std::string* /*error*/,
                        std::string* /*warning*/, int /*width*/, int /*height*/,
                        const unsigned char* bytes, int size, void* /*user_data*/) {
  if (image->bufferView < 0) {
    image->image.assign(bytes, bytes + size);
  }
  return true;
}

}  // namespace

GltfFile read_gltf_file(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  const bool binary = is_glb(content);
  if (!binary && lower_case_extension(path) == ".glb") {
    throw GltfFault("", "is not a glTF binary: it does not begin with \"glTF\"");
  }
  const std::string_view json = binary ? json_chunk(content) : std::string_view(content);
  if (json.size() > longest_json) {
    throw GltfFault(
        "", fmt::format("has {} bytes of JSON; up to {} are read", json.size(), longest_json));
  }
  References referred{.references = check_gltf_document(json),
                      .folder = path.has_parent_path() ? path.parent_path() : "."};
  require_confined_images(referred);

  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacks_into(referred));
  loader.SetImageLoader(keep_encoded_image, nullptr);
  const auto model = std::make_shared<tinygltf::Model>();
  std::string error;
  std::string warning;
  const bool loaded =
      binary ? loader.LoadBinaryFromMemory(model.get(), &error, &warning,
                                           reinterpret_cast<const unsigned char*>(content.data()),
                                           static_cast<unsigned>(little_endian_32(content, 8)))
             : loader.LoadASCIIFromString(model.get(), &error, &warning, content.data(),
                                          static_cast<unsigned>(content.size()), "");
  if (!loaded) {
    throw GltfFault("", sanitised(error));  // which can repeat a whole data: uri
  }
  return {.model = model,
          .folder = referred.folder,
          .sha256 = sha256(std::string_view(content)),
          .buffer_hashes = std::move(referred.hashes)};
}

}  // namespace foveola
