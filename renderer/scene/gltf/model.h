// A glTF document in memory. Properties that are decoded, moved or read often have structs; others
// stay JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_file/values.h"

namespace foveola {

using GltfBytes = std::vector<unsigned char>;

struct GltfBufferView {
  std::size_t buffer = 0;
  std::size_t offset = 0;  ///< bytes
  std::size_t length = 0;  ///< bytes
  std::size_t stride = 0;  ///< bytes; 0: elements are contiguous
};

/// The specification's numbers.
enum class GltfComponent : int {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// Returns use(example) with a value of the component's type.
template <typename Use>
auto with_type_of(GltfComponent component, Use use) {
  switch (component) {
    case GltfComponent::int8:
      return use(std::int8_t{});
    case GltfComponent::uint8:
      return use(std::uint8_t{});
    case GltfComponent::int16:
      return use(std::int16_t{});
    case GltfComponent::uint16:
      return use(std::uint16_t{});
    case GltfComponent::uint32:
      return use(std::uint32_t{});
    default:
      return use(float{});
  }
}

/// Bytes of a component.
inline std::size_t size_of(GltfComponent component) {
  return with_type_of(component, [](auto example) { return sizeof example; });
}

struct GltfAccessor {
  /// The elements that replace others.
  struct Sparse {
    std::size_t count = 0;
    int index_view = -1;
    std::size_t index_offset = 0;
    GltfComponent index_component = GltfComponent::uint8;
    int value_view = -1;
    std::size_t value_offset = 0;
  };

  int view = -1;  ///< -1: all elements are zero
  std::size_t offset = 0;
  std::size_t count = 0;
  GltfComponent component = GltfComponent::float32;
  int components = 1;  ///< of an element
  bool is_matrix = false;
  bool is_normalized = false;
  std::optional<Sparse> sparse;

  /// Bytes of an element.
  std::size_t element_size() const {
    return static_cast<std::size_t>(components) * size_of(component);
  }
};

enum class GltfMode : int { triangles = 4, triangle_strip, triangle_fan };

/// -1 if absent.
struct GltfPrimitive {
  GltfIndices attributes;  ///< accessors
  std::vector<GltfIndices> targets;
  int indices = -1;
  int material = -1;
  GltfMode mode = GltfMode::triangles;  ///< points and lines have lower numbers

  /// The accessor of attribute `name`, or -1.
  int attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
  }
};

struct GltfMesh {
  std::string name;
  std::vector<double> weights;
  std::vector<GltfPrimitive> primitives;
};

/// Absent values are -1 or an empty list.
struct GltfNode {
  std::string name;
  std::vector<int> children;
  int mesh = -1;
  int camera = -1;
  int skin = -1;
  int light = -1;                   ///< of KHR_lights_punctual
  bool is_visible = true;           ///< of KHR_node_visibility
  GltfIndices instance_attributes;  ///< accessors of EXT_mesh_gpu_instancing
  std::vector<double> weights;
  std::vector<double> matrix;  ///< if present, the next three are empty
  std::vector<double> translation;
  std::vector<double> rotation;
  std::vector<double> scale;
};

struct GltfImage {
  int view = -1;
  std::string uri;    ///< of an image without a view
  GltfBytes content;  ///< encoded, if the uri is a data: uri
};

struct GltfModel {
  /// checked: by checked_gltf_document. Buffers and the contents of images stay empty.
  explicit GltfModel(nlohmann::json checked);

  GltfValues root() const { return GltfValues(&document); }

  nlohmann::json document;
  std::vector<GltfBytes> buffers;
  std::vector<GltfBufferView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
  std::vector<GltfImage> images;
};

}  // namespace foveola
