// Reads glTF accessors, never a byte outside their buffer views.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/vec.h"

namespace tinygltf {
class Model;
}

namespace foveola {

/// Which elements of an accessor to read, in ascending order.
using ElementList = std::span<const std::uint32_t>;

/// Throws GltfFault unless the indices of every sparse accessor lie inside it, in strictly
/// ascending order. To be called once, before anything is read.
void check_sparse_accessors(const tinygltf::Model& model);

/// The number of elements of accessor `index`.
std::size_t element_count(const tinygltf::Model& model, int index);

// `place` is the JSON path of the reference to the accessor, for the GltfFault that each of these
// throws if the accessor is of the wrong type, reaches beyond a buffer view, or lacks an element of
// the list. An accessor without a buffer view is zero where no sparse elements replace it; those of
// more than 2^22 elements are refused, since they cost a file nothing.

/// All elements of a SCALAR of unsigned 8, 16 or 32 bits.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int index,
                                        const std::string& place);

// Vertex attributes of float, or of integers of 8 or 16 bits as KHR_mesh_quantization allows them:
// as they are, or normalised by the equations of the specification, section 3.11.

std::vector<Vec2> read_vec2s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place);
std::vector<Vec3> read_vec3s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place);
std::vector<Vec4> read_vec4s(const tinygltf::Model& model, int index, ElementList elements,
                             const std::string& place);

/// VEC3, to which an alpha of 1 is added, or VEC4; of float or of normalised unsigned integers.
std::vector<Vec4> read_colors(const tinygltf::Model& model, int index, ElementList elements,
                              const std::string& place);

/// All components of all elements, one after the other, of `components` to an element: floats, or,
/// but for matrices, integers of 8 or 16 bits as above.
std::vector<float> read_numbers(const tinygltf::Model& model, int index, int components,
                                const std::string& place);

}  // namespace foveola
