#include "renderer/scene/gltf/material_part.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace foveola {
namespace {

/// KHR_texture_transform's translation * rotation * scale, with the rotation of the extension's
/// text ("counter-clockwise", in coordinates whose v points down) and example; its GLSL listing
/// once rotated the other way (github.com/KhronosGroup/glTF, issue 1563).
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
  return limited(DVec3(value), lowest, highest, property).x;
}

Rgb MaterialContext::limited(const DVec3& value, double lowest, double highest,
                             const std::string& property) {
  const DVec3 result = glm::clamp(value, DVec3(lowest), DVec3(highest));
  if (result != value) {
    warn(property.substr(property.rfind('.') + 1) + " is clamped to its range", property);
  }
  return Rgb(result);
}

TextureUse MaterialContext::use(const GltfValues& info, Encoding encoding) {
  if (!info.exists() || textures_ == nullptr) {
    return {};
  }
  return use_of(info, textures_->add(info.integer("index"), encoding));
}

TextureUse MaterialContext::use_glossiness(const GltfValues& info, float factor) {
  if (!info.exists() || textures_ == nullptr) {
    return {};
  }
  return use_of(info, textures_->add_glossiness(info.integer("index"), factor));
}

TextureUse MaterialContext::use_of(const GltfValues& info, int texture) {
  if (texture < 0) {
    return {};
  }
  const GltfValues transform = info.extension("KHR_texture_transform");
  const int uv_set = transform.integer("texCoord", info.integer("texCoord", 0));
  const auto known = std::ranges::find(uv_sets_, uv_set);
  const auto number = static_cast<int>(known - uv_sets_.begin());
  if (known == uv_sets_.end()) {
    uv_sets_.push_back(uv_set);
  }
  return {.texture = texture, .uv_set = number, .texture_from_mesh = texture_matrix(transform)};
}

void MaterialContext::warn(const std::string& what, const std::string& property) {
  warnings_.add(what, fmt::format("{}.{}", place_, property));
}

float MaterialPart::normal_scale(const std::string& texture) const {
  constexpr double steepest = 1e3;
  return context_.limited(values_.object(texture.c_str()).number("scale", 1.0), -steepest, steepest,
                          place_of(texture + ".scale"));
}

}  // namespace foveola
