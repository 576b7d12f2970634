// Recognises glTF's primitives in the next version of a file.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "renderer/scene/gltf/geometry.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace foveola {

/// The primitives of one model, which must outlive this.
class PrimitiveDigests {
 public:
  explicit PrimitiveDigests(const tinygltf::Model& model) : model_(model) {}

  /// A SHA-256 of all that read_primitive() makes a mesh from. None for primitives with sparse
  /// accessors, with accessors that have no buffer view or too little data, and with morph targets.
  std::optional<std::string> of(const tinygltf::Primitive& primitive, const VertexNeeds& needs);

 private:
  /// Empty if there is none. Each is found once, however many primitives share the accessor.
  const std::string& of_accessor(int index);

  const tinygltf::Model& model_;
  std::map<int, std::string> of_accessors_;
};

}  // namespace foveola
