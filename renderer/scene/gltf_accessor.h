// Reads glTF accessors, never a byte outside their buffer views.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/vec.h"

namespace tinygltf {
class Model;
}

namespace foveola {

/// A run of elements [begin, end) of an accessor.
struct ElementRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// `place` is the JSON path of the reference to the accessor, for the GltfFault that each of these
// throws if the accessor is sparse, has no buffer view, is of the wrong type, reaches beyond its
// buffer view, or has no such range.

/// The number of elements of accessor `index`.
std::size_t element_count(const tinygltf::Model& model, int index);

/// SCALAR of unsigned 8, 16 or 32 bits.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int index,
                                        const std::string& place);

/// VEC3 of float.
std::vector<Vec3> read_vectors(const tinygltf::Model& model, int index, ElementRange range,
                               const std::string& place);

/// VEC2 of float, or of unsigned 8 or 16 bits normalised to [0, 1].
std::vector<Vec2> read_texture_coordinates(const tinygltf::Model& model, int index,
                                           ElementRange range, const std::string& place);

}  // namespace foveola
