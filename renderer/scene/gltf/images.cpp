#include "renderer/scene/gltf/images.h"

#include <stdexcept>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/scene/confined_file.h"
#include "renderer/scene/foreign_references.h"
#include "renderer/scene/gltf/fault.h"
#include "renderer/scene/sanitised.h"

namespace foveola {
namespace {

std::span<const unsigned char> bytes_of(const std::string& content) {
  return {reinterpret_cast<const unsigned char*>(content.data()), content.size()};
}

}  // namespace

void GltfImages::load(int image) {
  if (!loaded_.insert(image).second) {
    return;
  }
  const tinygltf::Image& source = file_.model->images[static_cast<std::size_t>(image)];
  if (source.bufferView >= 0) {
    const int buffer = file_.model->bufferViews[static_cast<std::size_t>(source.bufferView)].buffer;
    if (buffers_.insert(buffer).second) {
      encoded_bytes_ += file_.model->buffers[static_cast<std::size_t>(buffer)].data.size();
    }
  } else if (!source.image.empty()) {
    encoded_bytes_ += source.image.size();
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
  return percent_decoded(file_.model->images[static_cast<std::size_t>(image)].uri);
}

void GltfImages::load_file(int image, const std::filesystem::path& path) {
  if (!contents_.contains(path)) {
    contents_[path] = read_file(path);
    encoded_bytes_ += contents_[path].size();
  }
  paths_[image] = path;
}

std::span<const unsigned char> GltfImages::encoded(int image) const {
  const tinygltf::Image& source = file_.model->images[static_cast<std::size_t>(image)];
  if (source.bufferView >= 0) {
    const auto& view = file_.model->bufferViews[static_cast<std::size_t>(source.bufferView)];
    const auto& buffer = file_.model->buffers[static_cast<std::size_t>(view.buffer)];
    return std::span(buffer.data).subspan(view.byteOffset, view.byteLength);
  }
  return source.image.empty() ? bytes_of(contents_.at(paths_.at(image))) : source.image;
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

}  // namespace foveola
