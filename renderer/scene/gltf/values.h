// Typed access to the properties of a glTF extension, whose types have been checked.
#pragma once

#include <string>

#include <tiny_gltf.h>

#include "renderer/base/vec.h"

namespace foveola {

/// An object in an extension; every property may be absent.
class GltfValues {
 public:
  /// value: null for an absent object; must outlive this.
  explicit GltfValues(const tinygltf::Value* value) : value_(value) {}
  GltfValues(const tinygltf::ExtensionMap& extensions, const std::string& name)
      : value_(extensions.contains(name) ? &extensions.at(name) : nullptr) {}

  bool exists() const { return value_ != nullptr; }
  bool has(const std::string& name) const { return exists() && value_->Has(name); }
  /// Null if absent.
  const tinygltf::Value* get(const std::string& name) const {
    return has(name) ? &value_->Get(name) : nullptr;
  }
  GltfValues object(const std::string& name) const { return GltfValues(get(name)); }

  double number(const std::string& name, double absent) const {
    return has(name) ? value_->Get(name).GetNumberAsDouble() : absent;
  }
  int integer(const std::string& name, int absent) const {
    return has(name) ? value_->Get(name).GetNumberAsInt() : absent;
  }
  bool boolean(const std::string& name, bool absent) const {
    return has(name) ? value_->Get(name).Get<bool>() : absent;
  }
  glm::dvec2 vec2(const std::string& name, const glm::dvec2& absent) const {
    return has(name) ? glm::dvec2(element(name, 0), element(name, 1)) : absent;
  }
  DVec3 vec3(const std::string& name, const DVec3& absent) const {
    return has(name) ? DVec3(element(name, 0), element(name, 1), element(name, 2)) : absent;
  }
  /// Element `i` of a list of more.
  double element(const std::string& name, int i, double absent) const {
    return has(name) ? element(name, i) : absent;
  }

 private:
  double element(const std::string& name, int i) const {
    return value_->Get(name).Get(i).GetNumberAsDouble();
  }

  const tinygltf::Value* value_;
};

}  // namespace foveola
