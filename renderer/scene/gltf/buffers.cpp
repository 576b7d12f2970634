#include "renderer/scene/gltf/buffers.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/confined_file.h"
#include "renderer/scene/gltf/data_uri.h"
#include "renderer/scene/gltf/fault.h"

namespace foveola {
namespace {

using Json = nlohmann::json;

/// Files may be named any number of times, and each time they are read.
constexpr std::uintmax_t largest_total_size = std::uintmax_t{1} << 33;

/// Reads one buffer after the other.
class BufferReader {
 public:
  BufferReader(std::string_view binary, const std::filesystem::path& folder)
      : binary_(binary), folder_(folder) {}

  std::vector<unsigned char> read(const Json& buffer, std::size_t index, bool is_used) {
    const std::string place = fmt::format("buffers[{}]", index);
    const auto length = buffer["byteLength"].get<std::size_t>();
    if (buffer.contains("uri")) {
      return whole(content_of(buffer["uri"].get<std::string>(), place + ".uri"), length, place);
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
  /// The bytes that the buffer states; padding may follow them.
  static std::vector<unsigned char> whole(std::string_view content, std::size_t length,
                                          const std::string& place) {
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
          fmt::format("brings the files of the scene to more than {} bytes", largest_total_size));
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

/// What EXT_meshopt_compression says of a buffer or a buffer view; null if nothing.
const Json* compression_of(const Json& item) {
  const auto extensions = item.find("extensions");
  if (extensions == item.end()) {
    return nullptr;
  }
  const auto found = extensions->find("EXT_meshopt_compression");
  return found == extensions->end() ? nullptr : &*found;
}

/// For each buffer, whether a buffer view lies in it. One that is compressed lies elsewhere, in the
/// buffer that its extension names: its own is for programs that do not know the extension.
std::vector<bool> used_buffers(const Json& document, std::size_t count) {
  std::vector<bool> is_used(count, false);
  for (const Json& view : document.value("bufferViews", Json::array())) {
    const Json* const compression = compression_of(view);
    is_used[(compression != nullptr ? *compression : view)["buffer"].get<std::size_t>()] = true;
  }
  return is_used;
}

bool is_fallback(const Json& buffer) {
  const Json* const compression = compression_of(buffer);
  return compression != nullptr && compression->value("fallback", false);
}

}  // namespace

GltfBuffers read_gltf_buffers(const Json& document, std::string_view binary,
                              const std::filesystem::path& folder) {
  GltfBuffers result;
  const auto buffers = document.find("buffers");
  if (buffers == document.end()) {
    return result;
  }
  const std::vector<bool> is_used = used_buffers(document, buffers->size());
  BufferReader reader(binary, folder);
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const bool is_needed = is_used[i] || !is_fallback((*buffers)[i]);
    result.contents.push_back(is_needed ? reader.read((*buffers)[i], i, is_used[i])
                                        : std::vector<unsigned char>());
  }
  result.hashes = std::move(reader).take_hashes();
  return result;
}

}  // namespace foveola
