#include "renderer/scene/gltf/file.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/confined_file.h"
#include "renderer/scene/gltf/buffers.h"
#include "renderer/scene/gltf/container.h"
#include "renderer/scene/gltf/data_uri.h"
#include "renderer/scene/gltf/document.h"
#include "renderer/scene/gltf/draco.h"
#include "renderer/scene/gltf/fault.h"
#include "renderer/scene/gltf/meshopt.h"
#include "renderer/scene/gltf/node_list.h"
#include "renderer/scene/sanitised.h"

namespace foveola {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr std::size_t longest_json = std::size_t{1} << 30;

/// What stands in the document for a uri whose content has been read: tinygltf shall not decode it.
constexpr const char* content_is_here = "content";

/// The bytes of the images in data: uris, which `content_is_here` then replaces. A scene whose
/// unused images are missing can be shown, but one that names a file outside its folder is not to
/// be trusted.
std::vector<Bytes> take_embedded_images(Json& document, const std::filesystem::path& folder) {
  std::vector<Bytes> images;
  if (!document.contains("images")) {
    return images;
  }
  for (std::size_t i = 0; i < document["images"].size(); ++i) {
    Bytes& bytes = images.emplace_back();
    Json& image = document["images"][i];
    if (!image.contains("uri")) {
      continue;
    }
    const auto uri = image["uri"].get<std::string>();
    const std::string place = fmt::format("images[{}].uri", i);
    if (is_data_uri(uri)) {
      const std::optional<std::string> content = bytes_of_data_uri(uri);
      if (!content || content->empty()) {
        throw GltfFault(place, "is a data: uri that is not base64");
      }
      bytes.assign(content->begin(), content->end());
      image["uri"] = content_is_here;
      continue;
    }
    std::optional<std::filesystem::path> file;
    try {
      file = confined_file_if_there(folder, uri);
    } catch (const std::runtime_error& refusal) {
      throw GltfFault(place, refusal.what());
    }
    if (file) {
      require_no_output(*file);  // a texture that could not be read would only be warned of
    }
  }
  return images;
}

/// What tinygltf asks for, in the order in which it asks: the buffers, then the images that have a
/// uri.
struct Contents {
  std::vector<Bytes> items;
  std::size_t next = 0;
};

/// Gives the document's buffers the lengths of their contents, and returns what tinygltf will ask
/// for. Buffers that nothing uses get one byte, since tinygltf takes none that is empty.
Contents hand_over(Json& document, std::vector<Bytes> buffers, std::vector<Bytes> images) {
  Contents contents{.items = std::move(buffers)};
  for (std::size_t i = 0; i < contents.items.size(); ++i) {
    Bytes& content = contents.items[i];
    content.resize(std::max<std::size_t>(content.size(), 1));
    document["buffers"][i] = {{"byteLength", content.size()}, {"uri", content_is_here}};
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (document["images"][i].contains("uri")) {
      contents.items.push_back(std::move(images[i]));
    }
  }
  return contents;
}

/// False, which tinygltf takes well, for images in files of their own: they are read if they are
/// used.
bool take_next(Bytes* bytes, std::string* /*error*/, const std::string& /*name*/, void* user_data) {
  auto& contents = *static_cast<Contents*>(user_data);
  *bytes = std::move(contents.items.at(contents.next++));
  return !bytes->empty();
}

/// From version 2.9 on, tinygltf asks for a file's size before it reads it.
template <typename Callbacks>
void add_file_size(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](std::size_t* bytes, std::string* /*error*/,
                                      const std::string& /*name*/, void* user_data) {
      const auto& contents = *static_cast<const Contents*>(user_data);
      *bytes = contents.items.at(contents.next).size();
      return true;
    };
  }
}

/// Answers every file access of tinygltf out of `contents`. From version 2.9 on it keeps its own
/// way of reading files, which knows no folder to stay in, unless every callback is there: throws
/// std::logic_error if it does.
template <typename Loader>
void confine(Loader& loader, Contents& contents) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void*) { return true; };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = take_next;
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const Bytes&, void*) {
    return false;
  };
  callbacks.user_data = &contents;
  add_file_size(callbacks);
  if constexpr (std::is_void_v<decltype(loader.SetFsCallbacks(callbacks))>) {
    loader.SetFsCallbacks(callbacks);
  } else if (!loader.SetFsCallbacks(callbacks)) {
    throw std::logic_error("tinygltf would read files by itself");
  }
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

/// Takes the nodes out of the document.
std::vector<tinygltf::Node> take_nodes(Json& document) {
  const auto nodes = document.find("nodes");
  if (nodes == document.end()) {
    return {};
  }
  std::vector<tinygltf::Node> list = node_list_of(*nodes);
  document.erase(nodes);
  return list;
}

std::shared_ptr<tinygltf::Model> model_of(Json document, Contents contents) {
  std::vector<tinygltf::Node> nodes = take_nodes(document);
  tinygltf::TinyGLTF loader;
  confine(loader, contents);
  loader.SetImageLoader(keep_encoded_image, nullptr);
  auto model = std::make_shared<tinygltf::Model>();
  std::string error;
  std::string warning;
  const std::string text = document.dump();
  if (!loader.LoadASCIIFromString(model.get(), &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), "")) {
    throw GltfFault("", sanitised(error));
  }
  model->nodes = std::move(nodes);
  return model;
}

}  // namespace

GltfFile read_gltf_file(const std::filesystem::path& path, std::string& content) {
  read_file(path, content);
  if (!is_gltf_binary(content) && lower_case_extension(path) == ".glb") {
    throw GltfFault("", "is not a glTF binary: it does not begin with \"glTF\"");
  }
  const GltfParts parts = gltf_parts(content);
  if (parts.json.size() > longest_json) {
    throw GltfFault("", fmt::format("has {} bytes of JSON; up to {} are read", parts.json.size(),
                                    longest_json));
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  Json document = checked_gltf_document(parts.json);
  std::vector<Bytes> images = take_embedded_images(document, folder);
  GltfBuffers buffers = read_gltf_buffers(document, parts.binary, folder);
  decompress_meshopt(document, buffers.contents);
  decompress_draco(document, buffers.contents);
  Contents contents = hand_over(document, std::move(buffers.contents), std::move(images));
  return {.model = model_of(std::move(document), std::move(contents)),
          .folder = folder,
          .sha256 = sha256(std::string_view(content)),
          .buffer_hashes = std::move(buffers.hashes)};
}

}  // namespace foveola
