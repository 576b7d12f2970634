#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <fmt/format.h>

#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_mesh/buffers.h"
#include "renderer/scene/gltf_mesh/compression.h"

namespace foveola {
namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// Memory per triangle for decoding its connectivity: Draco's corner table and further data.
constexpr std::size_t bytes_per_triangle = 128;

struct DracoLimits {
  std::size_t max_points = 0;
  std::size_t max_triangles = 0;
  std::size_t max_bytes = 0;  ///< of all attributes during decoding, estimated
};

constexpr std::uint16_t oldest_format = DRACO_BITSTREAM_VERSION(2, 2);

/// A Draco decoder that checks the counts before allocating memory for them.
template <typename Decoder>
class LimitedDecoder : public Decoder {
 public:
  /// triangles_come_first: the connectivity's first count.
  LimitedDecoder(const DracoLimits& limits, bool triangles_come_first)
      : limits_(limits), triangles_come_first_(triangles_come_first) {}

  /// The exceeded limit; empty if none was.
  const std::string& fault() const { return fault_; }

 protected:
  bool DecodeConnectivity() override {
    return connectivity_is_allowed() && Decoder::DecodeConnectivity();
  }

  bool DecodeAllAttributes() override {
    return attributes_are_allowed() && Decoder::DecodeAllAttributes();
  }

 private:
  bool refuse(std::string fault) {
    fault_ = std::move(fault);
    return false;
  }

  bool connectivity_is_allowed() {
    if (this->bitstream_version() < oldest_format) {
      return refuse("is in a format older than Draco's 2.2");
    }
    draco::DecoderBuffer ahead = *this->buffer();
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) {
      return refuse("is cut off");
    }
    const std::uint32_t triangles = triangles_come_first_ ? first : second;
    const std::uint32_t points = triangles_come_first_ ? second : first;
    return counts_are_allowed(points, triangles);
  }

  bool counts_are_allowed(std::size_t points, std::size_t triangles) {
    if (points > limits_.max_points || triangles > limits_.max_triangles) {
      return refuse(
          fmt::format("has {} vertices and {} triangles, more than the {} and {} that its "
                      "accessors state",
                      points, triangles, limits_.max_points, limits_.max_triangles));
    }
    return true;
  }

  /// Called when the attributes are declared, and the points split at seams are counted.
  bool attributes_are_allowed() {
    if (!counts_are_allowed(this->point_cloud()->num_points(), 0)) {
      return false;
    }
    std::size_t bytes_per_point = 0;
    for (int i = 0; i < this->point_cloud()->num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *this->point_cloud()->attribute(i);
      constexpr std::size_t copies = 3;  // decoded, portable, and the prediction's
      const std::size_t component = std::max(4, draco::DataTypeLength(attribute.data_type()));
      bytes_per_point += copies * component * attribute.num_components();
    }
    if (bytes_per_point * this->point_cloud()->num_points() > limits_.max_bytes) {
      return refuse(fmt::format("would take {} bytes for each of {} vertices", bytes_per_point,
                                this->point_cloud()->num_points()));
    }
    return true;
  }

  const DracoLimits& limits_;
  bool triangles_come_first_;
  std::string fault_;
};

template <typename Decoder>
std::unique_ptr<draco::Mesh> decode(draco::DecoderBuffer& buffer, const DracoLimits& limits,
                                    bool triangles_come_first) {
  LimitedDecoder<Decoder> decoder(limits, triangles_come_first);
  auto mesh = std::make_unique<draco::Mesh>();
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, mesh.get());
  if (!decoder.fault().empty()) {
    throw std::runtime_error(decoder.fault());
  }
  if (!status.ok()) {
    throw std::runtime_error(
        fmt::format("cannot be decoded: the compressed data is damaged ({})", status.error_msg()));
  }
  return mesh;
}

std::unique_ptr<draco::Mesh> decode(std::span<const unsigned char> encoded,
                                    const DracoLimits& limits) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok() ||
      header.encoder_type != draco::TRIANGULAR_MESH) {
    throw std::runtime_error("holds no Draco mesh");
  }
  return header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING
             ? decode<draco::MeshEdgebreakerDecoder>(buffer, limits, false)
             : decode<draco::MeshSequentialDecoder>(buffer, limits, true);
}

/// The attribute's value at each point, as `components` numbers of type Component.
template <typename Component>
GltfBytes values_of(const draco::PointAttribute& attribute, std::size_t points, int components) {
  const std::size_t size = static_cast<std::size_t>(components) * sizeof(Component);
  GltfBytes bytes(points * size);
  std::array<Component, 4> value{};
  for (std::uint32_t i = 0; i < points; ++i) {
    attribute.ConvertValue(attribute.mapped_index(draco::PointIndex(i)),
                           static_cast<std::int8_t>(components), value.data());
    std::memcpy(&bytes[i * size], value.data(), size);
  }
  return bytes;
}

/// The values of the attribute with this unique id at each point: `components` numbers of type
/// `component`. nullopt if there is no such attribute.
std::optional<GltfBytes> values_in(const draco::Mesh& mesh, std::uint32_t id, int components,
                                   GltfComponent component) {
  const draco::PointAttribute* const attribute = mesh.GetAttributeByUniqueId(id);
  if (attribute == nullptr) {
    return std::nullopt;
  }
  return with_type_of(component, [&](auto example) {
    return values_of<decltype(example)>(*attribute, mesh.num_points(), components);
  });
}

/// The points of each triangle, one triangle after the other.
GltfBytes indices_in(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> indices;
  indices.reserve(std::size_t{3} * mesh.num_faces());
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
      indices.push_back(corner.value());
    }
  }
  GltfBytes bytes(indices.size() * sizeof(std::uint32_t));
  std::memcpy(bytes.data(), indices.data(), bytes.size());
  return bytes;
}

/// Decodes primitives one by one.
class DracoDecompressor {
 public:
  explicit DracoDecompressor(GltfModel& model) : model_(model) {}

  void decompress(GltfPrimitive& primitive, const GltfValues& extension, const std::string& place) {
    const draco::Mesh& mesh = mesh_of(extension.natural("bufferView"), primitive, place);
    for (const auto& [name, id] : extension.indices("attributes")) {
      if (const int accessor = primitive.attribute(name); accessor >= 0) {
        fill(accessor, mesh, id, fmt::format("{}.attributes.{}", place, name));
      }
    }
    fill_indices(primitive, mesh, place);
  }

 private:
  /// Each buffer view is decoded once.
  const draco::Mesh& mesh_of(std::size_t view_index, const GltfPrimitive& primitive,
                             const std::string& place) {
    if (const auto known = meshes_.find(view_index); known != meshes_.end()) {
      return *known->second;
    }
    const GltfBufferView& view = model_.views[view_index];
    const std::span<const unsigned char> bytes =
        std::span(model_.buffers[view.buffer]).subspan(view.offset, view.length);
    encoded_bytes_ += bytes.size();
    const DracoLimits limits = limits_of(primitive, place);
    try {
      return *(meshes_[view_index] = decode(bytes, limits));
    } catch (const std::runtime_error& fault) {
      throw GltfFault(place, fault.what());
    }
  }

  /// The primitive's accessors' counts, if modest.
  DracoLimits limits_of(const GltfPrimitive& primitive, const std::string& place) {
    constexpr std::size_t max_bytes = std::size_t{1} << 31;
    const int position = primitive.attribute("POSITION");
    if (position < 0) {
      throw GltfFault(place, "has no accessor for POSITION");
    }
    const std::size_t points = accessor(position).count;
    const std::size_t triangles =
        primitive.indices >= 0 ? accessor(primitive.indices).count / 3 : points;
    take(triangles * bytes_per_triangle, place);
    return {.max_points = points,
            .max_triangles = triangles,
            .max_bytes = max_bytes - std::min(max_bytes, decoded_bytes_)};
  }

  GltfAccessor& accessor(int index) { return model_.accessors[static_cast<std::size_t>(index)]; }

  void take(std::size_t bytes, const std::string& place) {
    decoded_bytes_ += bytes;
    require_gltf_memory_limit(decoded_bytes_, encoded_bytes_, place);
  }

  void fill(int index, const draco::Mesh& mesh, std::uint32_t id, const std::string& place) {
    if (!filled_.insert(index).second) {
      return;
    }
    constexpr int max_components = 4;
    GltfAccessor& target = accessor(index);
    const int components = std::min(target.components, max_components);
    take(std::size_t{16} * mesh.num_points(), place);
    std::optional<GltfBytes> values = values_in(mesh, id, components, target.component);
    if (!values) {
      throw GltfFault(place, fmt::format("names attribute {}, which the mesh does not have", id));
    }
    set_content(target, mesh.num_points(), std::move(*values), place);
  }

  void fill_indices(GltfPrimitive& primitive, const draco::Mesh& mesh, const std::string& place) {
    primitive.mode = GltfMode::triangles;
    if (primitive.indices < 0) {
      primitive.indices = static_cast<int>(model_.accessors.size());
      model_.accessors.emplace_back();
    }
    if (!filled_.insert(primitive.indices).second) {
      return;
    }
    GltfAccessor& target = accessor(primitive.indices);
    target.component = GltfComponent::uint32;
    take(std::size_t{12} * mesh.num_faces(), place);
    set_content(target, std::size_t{3} * mesh.num_faces(), indices_in(mesh), place);
  }

  void set_content(GltfAccessor& target, std::size_t count, GltfBytes bytes,
                   const std::string& place) {
    if (bytes.empty()) {
      throw GltfFault(place, "holds a mesh without triangles");
    }
    target.count = count;
    target.view = static_cast<int>(model_.views.size());
    target.offset = 0;
    model_.views.push_back({.buffer = model_.buffers.size(), .length = bytes.size()});
    model_.buffers.push_back(std::move(bytes));
  }

  GltfModel& model_;
  std::map<std::size_t, std::unique_ptr<const draco::Mesh>> meshes_;  ///< by buffer view
  std::set<int> filled_;                                              ///< accessors
  std::size_t decoded_bytes_ = 0;
  std::size_t encoded_bytes_ = 0;
};

}  // namespace

void decompress_draco(GltfModel& model) {
  DracoDecompressor decompressor(model);
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const GltfValues mesh = model.root().item("meshes", i);
    std::vector<GltfPrimitive>& primitives = model.meshes[i].primitives;
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      const GltfValues extension = mesh.item("primitives", k).extension(draco_extension);
      if (extension.exists()) {
        decompressor.decompress(
            primitives[k], extension,
            fmt::format("meshes[{}].primitives[{}].extensions.{}", i, k, draco_extension));
      }
    }
  }
}

}  // namespace foveola
