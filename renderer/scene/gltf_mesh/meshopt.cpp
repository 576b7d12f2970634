#include <span>
#include <string>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_mesh/buffers.h"
#include "renderer/scene/gltf_mesh/compression.h"

namespace foveola {
namespace {

constexpr const char* meshopt_extension = "EXT_meshopt_compression";

/// The extension's properties of a buffer view.
struct Compressed {
  std::span<const unsigned char> bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

Compressed read_extension(const GltfValues& extension, const std::vector<GltfBytes>& buffers,
                          const std::string& place) {
  const GltfBytes& buffer = buffers[extension.natural("buffer")];
  const std::size_t offset = extension.natural("byteOffset");
  const std::size_t length = extension.natural("byteLength");
  if (offset + length > buffer.size()) {
    throw GltfFault(place, fmt::format("ends at byte {}, but its buffer has {}", offset + length,
                                       buffer.size()));
  }
  return {.bytes = std::span(buffer).subspan(offset, length),
          .count = extension.natural("count"),
          .stride = extension.natural("byteStride"),
          .mode = extension.text("mode"),
          .filter = extension.text("filter", "NONE")};
}

/// The extension's rules for strides and counts, which meshoptimizer does not check.
void require_decodable(const Compressed& source, const std::string& place) {
  const bool is_attributes = source.mode == "ATTRIBUTES";
  const bool fits_mode = is_attributes ? source.stride % 4 == 0 && source.stride <= 256
                                       : source.stride == 2 || source.stride == 4;
  if (!fits_mode || (source.mode == "TRIANGLES" && source.count % 3 != 0)) {
    throw GltfFault(place, fmt::format("has a byteStride of {} and a count of {}, which {} cannot "
                                       "have",
                                       source.stride, source.count, source.mode));
  }
  const bool fits_filter =
      source.filter == "NONE" ||
      (is_attributes && (source.filter == "EXPONENTIAL" || source.stride == 8 ||
                         (source.filter == "OCTAHEDRAL" && source.stride == 4)));
  if (!fits_filter) {
    throw GltfFault(place, fmt::format("has the filter {}, which its mode or its byteStride of {} "
                                       "cannot have",
                                       source.filter, source.stride));
  }
}

/// Decodes into `decoded`. Returns false for invalid data.
bool decode(const Compressed& source, GltfBytes& decoded) {
  const unsigned char* const bytes = source.bytes.data();
  const std::size_t size = source.bytes.size();
  void* const target = decoded.data();
  if (source.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(target, source.count, source.stride, bytes, size) == 0;
  }
  if (source.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(target, source.count, source.stride, bytes, size) == 0;
  }
  return meshopt_decodeIndexSequence(target, source.count, source.stride, bytes, size) == 0;
}

void apply_filter(const Compressed& source, GltfBytes& decoded) {
  if (source.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(decoded.data(), source.count, source.stride);
  } else if (source.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(decoded.data(), source.count, source.stride);
  } else if (source.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), source.count, source.stride);
  }
}

GltfBytes decode_view(const Compressed& source, const std::string& place) {
  GltfBytes result(source.count * source.stride);
  if (!decode(source, result)) {
    throw GltfFault(place, "cannot be decoded: the compressed data is damaged");
  }
  apply_filter(source, result);
  return result;
}

}  // namespace

void decompress_meshopt(GltfModel& model) {
  // The limit holds for all views together.
  std::size_t decoded_bytes = 0;
  std::size_t encoded_bytes = 0;
  for (std::size_t i = 0; i < model.views.size(); ++i) {
    const GltfValues extension = model.root().item("bufferViews", i).extension(meshopt_extension);
    if (!extension.exists()) {
      continue;
    }
    const std::string place = fmt::format("bufferViews[{}].extensions.{}", i, meshopt_extension);
    const Compressed source = read_extension(extension, model.buffers, place);
    require_decodable(source, place);
    decoded_bytes += source.count * source.stride;
    encoded_bytes += source.bytes.size();
    require_gltf_memory_limit(decoded_bytes, encoded_bytes, place);
    GltfBytes bytes = decode_view(source, place);
    model.views[i] = {
        .buffer = model.buffers.size(), .length = bytes.size(), .stride = model.views[i].stride};
    model.buffers.push_back(std::move(bytes));
  }
}

}  // namespace foveola
