// A fault inside a glTF file; load_gltf adds the file's name and turns it into an Error.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace foveola {

class GltfFault : public std::runtime_error {
 public:
  /// where: a JSON path such as "meshes[3].primitives[0].attributes.POSITION", or empty for the
  /// file as a whole.
  GltfFault(std::string where, const std::string& what)
      : std::runtime_error(what), where_(std::move(where)) {}

  const std::string& where() const { return where_; }

 private:
  std::string where_;
};

}  // namespace foveola
