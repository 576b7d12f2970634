#include "renderer/scene/gltf_mesh/buffers.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/gltf_file/data_uri.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/references.h"
#include "renderer/scene/textures/decoded_memory.h"

namespace foveola {
namespace {

/// Files may be named any number of times, and are read each time.
constexpr std::uintmax_t largest_total_size = std::uintmax_t{1} << 33;

/// Reads buffers one by one.
class BufferReader {
 public:
  BufferReader(std::string_view binary, const std::filesystem::path& folder)
      : binary_(binary), folder_(folder) {}

  GltfBytes read(const GltfValues& buffer, std::size_t index, bool is_used) {
    const std::string place = fmt::format("buffers[{}]", index);
    const std::size_t length = buffer.natural("byteLength");
    if (buffer.has("uri")) {
      return whole(content_of(buffer.text("uri"), place + ".uri"), length, place);
    }
    if (index == 0 && !binary_.empty()) {
      return whole(binary_, length, place);
    }
    if (is_used) {
      throw GltfFault(place + ".uri",
                      "is missing: only the first buffer may lie in the file "
                      "itself, which is then a .glb");
    }
    return {};
  }

  FileHashes take_hashes() && { return std::move(hashes_); }

 private:
  /// The buffer's stated bytes; padding may follow them.
  static GltfBytes whole(std::string_view content, std::size_t length, const std::string& place) {
    if (content.size() < length) {
      throw GltfFault(place, fmt::format("size mismatch: it states {} bytes, but there are {}",
                                         length, content.size()));
    }
    return {content.begin(), content.begin() + static_cast<std::ptrdiff_t>(length)};
  }

  std::string content_of(const std::string& uri, const std::string& place) {
    if (is_data_uri(uri)) {
      std::optional<std::string> bytes = bytes_of_data_uri(uri);
      if (!bytes) {
        throw GltfFault(place, "is a data: uri that is not base64");
      }
      return std::move(*bytes);
    }
    try {
      return content_of_file(uri);
    } catch (const OutputIsInput&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw GltfFault(place, error.what());
    }
  }

  std::string content_of_file(const std::string& uri) {
    const std::filesystem::path path = confined_file(folder_, uri);
    total_size_ += std::filesystem::file_size(path);
    if (total_size_ > largest_total_size) {
      throw std::runtime_error(
          fmt::format("the scene's files hold more than {} bytes", largest_total_size));
    }
    std::string content = read_file(path);
    if (content.empty()) {
      throw std::runtime_error("refers to an empty file");
    }
    hashes_[path] = sha256(std::string_view(content));
    return content;
  }

  std::string_view binary_;
  const std::filesystem::path& folder_;
  std::uintmax_t total_size_ = 0;
  FileHashes hashes_;
};

constexpr const char* compression = "EXT_meshopt_compression";

/// For each buffer, whether a buffer view lies in it. A compressed view lies in the buffer that its
/// extension names: its own is for programs that do not support the extension.
std::vector<bool> used_buffers(const GltfValues& document) {
  std::vector<bool> is_used(document.size("buffers"), false);
  for (std::size_t i = 0; i < document.size("bufferViews"); ++i) {
    const GltfValues view = document.item("bufferViews", i);
    const GltfValues compressed = view.extension(compression);
    is_used[(compressed.exists() ? compressed : view).natural("buffer")] = true;
  }
  return is_used;
}

}  // namespace

FileHashes read_gltf_buffers(GltfModel& model, std::string_view binary,
                             const std::filesystem::path& folder) {
  const std::vector<bool> is_used = used_buffers(model.root());
  BufferReader reader(binary, folder);
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    const GltfValues buffer = model.root().item("buffers", i);
    const bool is_fallback = buffer.extension(compression).boolean("fallback", false);
    model.buffers.push_back(is_used[i] || !is_fallback ? reader.read(buffer, i, is_used[i])
                                                       : GltfBytes());
  }
  return std::move(reader).take_hashes();
}

void require_gltf_memory_limit(std::size_t decoded_bytes, std::size_t encoded_bytes,
                               const std::string& place) {
  try {
    require_modest_memory(decoded_bytes, encoded_bytes);
  } catch (const std::runtime_error& refusal) {
    throw GltfFault(place, refusal.what());
  }
}

}  // namespace foveola
