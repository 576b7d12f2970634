#include "renderer/scene/gltf_file/values.h"

#include <nlohmann/json.hpp>

namespace foveola {
namespace {

using Json = nlohmann::json;

/// `value`, if it exists and `is_right` holds for it; else `absent`.
template <typename Value>
Value value_or(const Json* value, bool (Json::*is_right)() const noexcept, Value absent) {
  return value != nullptr && (value->*is_right)() ? value->get<Value>() : absent;
}

}  // namespace

const Json* GltfValues::find(const char* name) const {
  if (value_ == nullptr) {
    return nullptr;
  }
  const auto found = value_->find(name);
  return found == value_->end() ? nullptr : &*found;
}

double GltfValues::number(const char* name, double absent) const {
  return value_or(find(name), &Json::is_number, absent);
}

int GltfValues::integer(const char* name, int absent) const {
  return value_or(find(name), &Json::is_number, absent);
}

std::size_t GltfValues::natural(const char* name, std::size_t absent) const {
  return value_or(find(name), &Json::is_number, absent);
}

bool GltfValues::boolean(const char* name, bool absent) const {
  return value_or(find(name), &Json::is_boolean, absent);
}

std::string GltfValues::text(const char* name, const char* absent) const {
  return value_or(find(name), &Json::is_string, std::string(absent));
}

glm::dvec2 GltfValues::vec2(const char* name, const glm::dvec2& absent) const {
  return {element(name, 0, absent.x), element(name, 1, absent.y)};
}

DVec3 GltfValues::vec3(const char* name, const DVec3& absent) const {
  return {element(name, 0, absent.x), element(name, 1, absent.y), element(name, 2, absent.z)};
}

double GltfValues::element(const char* name, std::size_t i, double absent) const {
  return i < size(name) ? (*find(name))[i].get<double>() : absent;
}

std::vector<double> GltfValues::numbers(const char* name) const {
  return value_or(find(name), &Json::is_array, std::vector<double>());
}

std::vector<int> GltfValues::integers(const char* name) const {
  return value_or(find(name), &Json::is_array, std::vector<int>());
}

std::vector<std::string> GltfValues::texts(const char* name) const {
  return value_or(find(name), &Json::is_array, std::vector<std::string>());
}

GltfIndices GltfValues::indices(const char* name) const {
  return value_or(find(name), &Json::is_object, GltfIndices());
}

std::vector<GltfIndices> GltfValues::list_of_indices(const char* name) const {
  return value_or(find(name), &Json::is_array, std::vector<GltfIndices>());
}

std::size_t GltfValues::size(const char* name) const {
  const Json* const list = find(name);
  return list != nullptr && list->is_array() ? list->size() : 0;
}

GltfValues GltfValues::item(const char* name, std::size_t i) const {
  return GltfValues(&(*find(name))[i]);
}

}  // namespace foveola
