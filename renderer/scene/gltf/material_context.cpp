#include "renderer/scene/gltf/material_context.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/scene/gltf/values.h"

namespace foveola {
namespace {

/// KHR_texture_transform's translation * rotation * scale, with the rotation as the extension's
/// text ("counter-clockwise", in coordinates whose v points down) and example have it; its GLSL
/// listing once turned the other way (github.com/KhronosGroup/glTF, issue 1563).
Mat3x2 texture_matrix(const GltfValues& transform) {
  const glm::dvec2 offset = transform.vec2("offset", {0.0, 0.0});
  const glm::dvec2 scale = transform.vec2("scale", {1.0, 1.0});
  const double rotation = transform.number("rotation", 0.0);
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  const glm::dmat3x2 matrix(c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x,
                            offset.y);
  return Mat3x2(matrix);
}

}  // namespace

float MaterialContext::limited(double value, double lowest, double highest,
                               const std::string& property) {
  const double result = std::clamp(value, lowest, highest);
  if (result != value) {
    warn(property.substr(property.rfind('.') + 1) + " is limited to the range it may have",
         property);
  }
  return static_cast<float>(result);
}

Rgb MaterialContext::limited(const DVec3& value, double lowest, double highest,
                             const std::string& property) {
  const DVec3 result = glm::clamp(value, DVec3(lowest), DVec3(highest));
  if (result != value) {
    warn(property.substr(property.rfind('.') + 1) + " is limited to the range it may have",
         property);
  }
  return Rgb(result);
}

TextureUse MaterialContext::use(const TextureReference& reference, Encoding encoding) {
  return use_of(reference, [&] { return textures_->add(reference.index, encoding); });
}

TextureUse MaterialContext::use_glossiness(const TextureReference& reference, float factor) {
  return use_of(reference, [&] { return textures_->add_glossiness(reference.index, factor); });
}

template <typename Add>
TextureUse MaterialContext::use_of(const TextureReference& reference, Add add) {
  if (reference.index < 0 || textures_ == nullptr) {
    return {};
  }
  const int texture = add();
  if (texture < 0) {
    return {};
  }
  const GltfValues transform(reference.transform);
  const int uv_set = transform.integer("texCoord", reference.tex_coord);
  const auto known = std::find(uv_sets_.begin(), uv_sets_.end(), uv_set);
  const auto number = static_cast<int>(known - uv_sets_.begin());
  if (known == uv_sets_.end()) {
    uv_sets_.push_back(uv_set);
  }
  return {.texture = texture, .uv_set = number, .texture_from_mesh = texture_matrix(transform)};
}

void MaterialContext::warn(const std::string& what, const std::string& property) {
  warnings_.add(what, fmt::format("{}.{}", place_, property));
}

}  // namespace foveola
