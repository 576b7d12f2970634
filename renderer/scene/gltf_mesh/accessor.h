// Reads glTF accessors with bounds checks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf/model.h"

namespace foveola {

/// Elements of an accessor to read, in ascending order.
using ElementList = std::span<const std::uint32_t>;

/// Throws GltfFault unless the indices of every sparse accessor lie inside it, in strictly
/// ascending order. To be called once, before anything is read.
void check_sparse_accessors(const GltfModel& model);

/// Number of elements of accessor `index`.
std::size_t element_count(const GltfModel& model, int index);

// `place` is the JSON path of the reference to the accessor, for the GltfFault that each of these
// throws if the accessor is of the wrong type, reaches beyond a buffer view, or lacks an element of
// the list. An accessor without a buffer view holds zeros, except for its sparse elements. Above
// 2^22 elements it is refused, since zeros take no space in a file.

/// All elements of an unsigned SCALAR of 8, 16 or 32 bits.
std::vector<std::uint32_t> read_indices(const GltfModel& model, int index,
                                        const std::string& place);

// Vertex attributes of float, or of integers of 8 or 16 bits as in KHR_mesh_quantization:
// unchanged, or normalised by the equations of the specification, section 3.11.

std::vector<Vec2> read_vec2s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place);
std::vector<Vec3> read_vec3s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place);
std::vector<Vec4> read_vec4s(const GltfModel& model, int index, ElementList elements,
                             const std::string& place);

/// VEC3 with an added alpha of 1, or VEC4; of float or of normalised unsigned integers.
std::vector<Vec4> read_colors(const GltfModel& model, int index, ElementList elements,
                              const std::string& place);

/// One of these functions.
template <typename Value>
using AccessorFunction = std::vector<Value> (*)(const GltfModel&, int, ElementList,
                                                const std::string& place);

/// Reads accessors that have one element per vertex of a primitive.
class VertexReader {
 public:
  /// used: the vertices whose elements are read. model: must outlive this.
  VertexReader(const GltfModel& model, ElementList used, std::size_t vertex_count)
      : model_(model), used_(used), vertex_count_(vertex_count) {}

  template <typename Value>
  std::vector<Value> read(AccessorFunction<Value> function, int index,
                          const std::string& place) const {
    require_count(index, place);
    return function(model_, index, used_, place);
  }

 private:
  /// Throws GltfFault unless the accessor has an element for each vertex.
  void require_count(int index, const std::string& place) const;

  const GltfModel& model_;
  ElementList used_;
  std::size_t vertex_count_;
};

/// All components of all elements, consecutive, `components` per element: floats, or, except for
/// matrices, integers of 8 or 16 bits as above.
std::vector<float> read_numbers(const GltfModel& model, int index, int components,
                                const std::string& place);

}  // namespace foveola
