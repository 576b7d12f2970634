// Reads the properties of an object of a checked glTF document.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include "renderer/base/vec.h"

namespace foveola {

/// Indices by their purpose.
using GltfIndices = std::map<std::string, int>;

/// A JSON object; null has no properties. A property that is absent, or has another type in an
/// unchecked document, has the value `absent`, or is empty.
class GltfValues {
 public:
  /// value: null for none; must outlive this.
  explicit GltfValues(const nlohmann::json* value = nullptr) : value_(value) {}

  bool exists() const { return value_ != nullptr; }
  bool has(const char* name) const { return find(name) != nullptr; }
  GltfValues object(const char* name) const { return GltfValues(find(name)); }
  GltfValues extension(const char* name) const { return object("extensions").object(name); }

  double number(const char* name, double absent) const;
  int integer(const char* name, int absent = -1) const;
  std::size_t natural(const char* name, std::size_t absent = 0) const;
  bool boolean(const char* name, bool absent) const;
  std::string text(const char* name, const char* absent = "") const;
  glm::dvec2 vec2(const char* name, const glm::dvec2& absent) const;
  DVec3 vec3(const char* name, const DVec3& absent) const;
  /// Element `i` of a list of several numbers.
  double element(const char* name, std::size_t i, double absent) const;
  std::vector<double> numbers(const char* name) const;
  std::vector<int> integers(const char* name) const;
  std::vector<std::string> texts(const char* name) const;
  GltfIndices indices(const char* name) const;
  std::vector<GltfIndices> list_of_indices(const char* name) const;

  /// The number of elements of list `name`, and its element `i`, an object.
  std::size_t size(const char* name) const;
  GltfValues item(const char* name, std::size_t i) const;

 private:
  const nlohmann::json* find(const char* name) const;

  const nlohmann::json* value_;
};

}  // namespace foveola
