#include "renderer/scene/gltf/draco_mesh.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <fmt/format.h>

namespace foveola {
namespace {

constexpr std::uint16_t oldest_format = DRACO_BITSTREAM_VERSION(2, 2);

/// A decoder of Draco's that looks at the counts before it takes memory for them.
template <typename Decoder>
class LimitedDecoder : public Decoder {
 public:
  /// triangles_come_first: which of the two counts the connectivity begins with.
  LimitedDecoder(const DracoLimits& limits, bool triangles_come_first)
      : limits_(limits), triangles_come_first_(triangles_come_first) {}

  /// What was beyond the limits; empty if nothing was.
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
    if (points > limits_.most_points || triangles > limits_.most_triangles) {
      return refuse(
          fmt::format("has {} vertices and {} triangles, more than the {} and {} that its "
                      "accessors state",
                      points, triangles, limits_.most_points, limits_.most_triangles));
    }
    return true;
  }

  /// By now the attributes are declared, and the points counted that seams have split.
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
    if (bytes_per_point * this->point_cloud()->num_points() > limits_.most_bytes) {
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

/// The attribute's value in each point, in `components` numbers of type Component.
template <typename Component>
std::vector<unsigned char> values_of(const draco::PointAttribute& attribute, std::size_t points,
                                     int components) {
  const std::size_t size = static_cast<std::size_t>(components) * sizeof(Component);
  std::vector<unsigned char> bytes(points * size);
  std::array<Component, 4> value{};
  for (std::uint32_t i = 0; i < points; ++i) {
    attribute.ConvertValue(attribute.mapped_index(draco::PointIndex(i)),
                           static_cast<std::int8_t>(components), value.data());
    std::memcpy(&bytes[i * size], value.data(), size);
  }
  return bytes;
}

}  // namespace

DracoMesh::DracoMesh(std::span<const unsigned char> encoded, const DracoLimits& limits)
    : mesh_(decode(encoded, limits)) {}

DracoMesh::~DracoMesh() = default;

std::size_t DracoMesh::points() const { return mesh_->num_points(); }

std::size_t DracoMesh::triangles() const { return mesh_->num_faces(); }

std::vector<std::uint32_t> DracoMesh::indices() const {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * triangles());
  for (std::uint32_t i = 0; i < mesh_->num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh_->face(draco::FaceIndex(i))) {
      indices.push_back(corner.value());
    }
  }
  return indices;
}

std::optional<std::vector<unsigned char>> DracoMesh::values(std::uint32_t id, int components,
                                                            int component_type) const {
  const draco::PointAttribute* const attribute = mesh_->GetAttributeByUniqueId(id);
  if (attribute == nullptr) {
    return std::nullopt;
  }
  switch (component_type) {
    case 5120:
      return values_of<std::int8_t>(*attribute, points(), components);
    case 5121:
      return values_of<std::uint8_t>(*attribute, points(), components);
    case 5122:
      return values_of<std::int16_t>(*attribute, points(), components);
    case 5123:
      return values_of<std::uint16_t>(*attribute, points(), components);
    case 5125:
      return values_of<std::uint32_t>(*attribute, points(), components);
    default:
      return values_of<float>(*attribute, points(), components);
  }
}

}  // namespace foveola
