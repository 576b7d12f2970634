#include "renderer/scene/gltf_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/scene/disarmed.h"

namespace foveola {
namespace {

constexpr double brightest_light = 1e9;

PunctualLight::Kind kind_of(const tinygltf::Light& source) {
  if (source.type == "directional") {
    return PunctualLight::Kind::directional;
  }
  return source.type == "spot" ? PunctualLight::Kind::spot : PunctualLight::Kind::point;
}

Rgb intensity_of(const tinygltf::Light& source, const std::string& place, Warnings& warnings) {
  const DVec3 color =
      source.color.empty() ? DVec3(1.0) : DVec3(source.color[0], source.color[1], source.color[2]);
  const DVec3 intensity = color * source.intensity;
  const DVec3 limited = glm::clamp(intensity, DVec3(0.0), DVec3(brightest_light));
  if (limited != intensity) {
    warnings.add("the intensity of a light is limited to the range it may have", place);
  }
  return Rgb(limited);
}

/// The extension: 0 <= inner < outer <= pi / 2.
void read_cone(const tinygltf::SpotLight& source, const std::string& place, PunctualLight& light,
               Warnings& warnings) {
  constexpr double widest = std::numbers::pi / 2.0;
  constexpr double narrowest = 1e-4;
  const double outer = std::clamp(source.outerConeAngle, narrowest, widest);
  const double inner = std::clamp(source.innerConeAngle, 0.0, outer);
  light.outer_cone_rad = static_cast<float>(outer);
  light.inner_cone_rad = static_cast<float>(inner);
  constexpr double rounding = 1e-5;  // exporters write pi / 2 with few digits
  if (std::abs(outer - source.outerConeAngle) > rounding ||
      std::abs(inner - source.innerConeAngle) > rounding) {
    warnings.add("the cone of a spot light is limited to the range it may have", place);
  }
}

}  // namespace

std::vector<PunctualLight> read_lights(const tinygltf::Model& model,
                                       const std::vector<PlacedItem>& lights, const DVec3& origin,
                                       Warnings& warnings) {
  std::vector<PunctualLight> result;
  for (const PlacedItem& item : lights) {
    const tinygltf::Light& source = model.lights[item.index];
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(item.placement.node)];
    const DMat4& world_from_local = item.placement.world_from_local;
    const std::string place = fmt::format("lights[{}]", item.index);
    PunctualLight light;
    light.name = disarmed(node.name.empty() ? source.name : node.name);
    light.kind = kind_of(source);
    light.intensity = intensity_of(source, place, warnings);
    light.position = Vec3(DVec3(world_from_local[3]) - origin);
    if (source.range > 0.0) {
      warnings.add("the range of a light is ignored: it shines on with the square of the distance",
                   place);
    }
    if (light.kind == PunctualLight::Kind::spot) {
      read_cone(source.spot, place, light, warnings);
    }
    if (light.kind != PunctualLight::Kind::point) {
      const DVec3 direction = -DVec3(world_from_local[2]);
      const double length = glm::length(direction);
      if (!(length > 0.0)) {
        warnings.add("a light whose node has no direction is left out",
                     fmt::format("nodes[{}]", item.placement.node));
        continue;
      }
      light.direction = Vec3(direction / length);
    }
    if (max_component(light.intensity) > 0.0F) {
      result.push_back(light);
    }
  }
  return result;
}

}  // namespace foveola
