#include "renderer/scene/gltf/digest.h"

#include <cstddef>
#include <span>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/files/digest.h"

namespace foveola {
namespace {

std::string text_of(const TextureUse& use) {
  std::string text = fmt::format("uv set {}", use.uv_set);
  for (int column = 0; column < 3; ++column) {
    const Vec2 image = use.texture_from_mesh[column];
    text += fmt::format(" {} {}", image.x, image.y);
  }
  return text;
}

std::string text_of(const VertexNeeds& needs) {
  std::string text;
  for (const int set : needs.uv_sets) {
    text += fmt::format("{},", set);
  }
  return needs.normal_texture ? text + text_of(*needs.normal_texture) : text;
}

/// The bytes from the first element to the last, and what lies between them; none if they are not
/// all there.
std::optional<std::span<const unsigned char>> bytes_of(const tinygltf::Model& model,
                                                       const tinygltf::Accessor& accessor) {
  if (accessor.bufferView < 0 || accessor.sparse.isSparse || accessor.count == 0) {
    return std::nullopt;
  }
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const auto& buffer = model.buffers.at(static_cast<std::size_t>(view.buffer));
  const int stride = accessor.ByteStride(view);
  const int size =
      tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(accessor.componentType)) *
      tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type));
  if (stride <= 0 || size <= 0) {
    return std::nullopt;
  }
  const std::size_t length =
      (accessor.count - 1) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(size);
  const std::size_t end = accessor.byteOffset + length;
  if (end > view.byteLength || view.byteOffset + end > buffer.data.size()) {
    return std::nullopt;
  }
  return std::span(buffer.data).subspan(view.byteOffset + accessor.byteOffset, length);
}

}  // namespace

std::optional<std::string> PrimitiveDigests::of(const tinygltf::Primitive& primitive,
                                                const VertexNeeds& needs) {
  if (!primitive.targets.empty()) {
    return std::nullopt;
  }
  std::string text = fmt::format("mode {}\nneeds {}\n", primitive.mode, text_of(needs));
  const auto add = [&](const std::string& name, int accessor) {
    const std::string& digest = of_accessor(accessor);
    text += fmt::format("{} {}\n", name, digest);
    return !digest.empty();
  };
  for (const auto& [name, accessor] : primitive.attributes) {
    if (!add(name, accessor)) {
      return std::nullopt;
    }
  }
  if (primitive.indices >= 0 && !add("indices", primitive.indices)) {
    return std::nullopt;
  }
  return sha256(std::string_view(text));
}

const std::string& PrimitiveDigests::of_accessor(int index) {
  const auto [known, is_new] = of_accessors_.try_emplace(index);
  if (is_new) {
    const auto& accessor = model_.accessors.at(static_cast<std::size_t>(index));
    if (const auto bytes = bytes_of(model_, accessor)) {
      const auto& view = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
      const std::string layout =
          fmt::format("{} {} {} {} {}", accessor.componentType, accessor.type, accessor.count,
                      accessor.normalized, accessor.ByteStride(view));
      Sha256 digest;
      digest.update(std::as_bytes(std::span(layout)));
      digest.update(std::as_bytes(*bytes));
      known->second = digest.hex();
    }
  }
  return known->second;
}

}  // namespace foveola
