#include "renderer/scene/gltf/lights.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "renderer/scene/gltf_file/values.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

constexpr double brightest_light = 1e9;
constexpr double lumens_per_watt = 683.0;
constexpr double largest_radius_m = 1e6;
constexpr double largest_angular_radius_rad = std::numbers::pi / 4.0;

using Version = std::array<int, 3>;

/// "MAJOR.MINOR.PATCH" with any suffix.
std::optional<Version> parse_version(std::string_view text) {
  Version version{};
  for (int& number : version) {
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc()) {
      return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    text.remove_prefix(text.starts_with('.') ? 1 : 0);
  }
  return version;
}

/// The version of Blender's exporter; nullopt for other generators.
std::optional<Version> blender_exporter_version(std::string_view generator) {
  constexpr std::string_view exporter = "Khronos glTF Blender I/O v";
  return generator.starts_with(exporter) ? parse_version(generator.substr(exporter.size()))
                                         : std::nullopt;
}

/// nullopt for a type unknown to KHR_lights_punctual.
std::optional<PunctualLight::Kind> kind_of(std::string_view type) {
  if (type == "directional") {
    return PunctualLight::Kind::directional;
  }
  if (type == "spot") {
    return PunctualLight::Kind::spot;
  }
  return type == "point" ? std::optional(PunctualLight::Kind::point) : std::nullopt;
}

Rgb intensity_of(const GltfValues& source, LightUnits units, const std::string& place,
                 Warnings& warnings) {
  const double units_per_watt = units == LightUnits::photometric ? lumens_per_watt : 1.0;
  const DVec3 intensity =
      source.vec3("color", DVec3(1.0)) * (source.number("intensity", 1.0) / units_per_watt);
  const DVec3 limited = glm::clamp(intensity, DVec3(0.0), DVec3(brightest_light));
  if (limited != intensity) {
    warnings.add("the intensity of a light is clamped to its range", place);
  }
  return Rgb(limited);
}

/// By the extension: 0 <= inner < outer <= pi / 2.
void read_cone(const GltfValues& source, PunctualLight::ConeEdge edge, const std::string& place,
               PunctualLight& light, Warnings& warnings) {
  constexpr double widest = std::numbers::pi / 2.0;
  constexpr double narrowest = 1e-4;
  const double stated_outer = source.number("outerConeAngle", std::numbers::pi / 4.0);
  const double stated_inner = source.number("innerConeAngle", 0.0);
  const double outer = std::clamp(stated_outer, narrowest, widest);
  const double inner = std::clamp(stated_inner, 0.0, outer);
  light.outer_cone_rad = static_cast<float>(outer);
  const bool is_cycles = edge != PunctualLight::ConeEdge::squared;
  light.inner_cone_rad =
      static_cast<float>(is_cycles ? cycles_inner_cone_rad(inner, outer) : inner);
  light.cone_edge = edge;
  constexpr double rounding = 1e-5;  // exporters write pi / 2 with few digits
  if (std::abs(outer - stated_outer) > rounding || std::abs(inner - stated_inner) > rounding) {
    warnings.add("the cone of a spot light is clamped to its range", place);
  }
}

/// A number of the light's extras, in [0, highest]; 0 if absent.
float size_of(const GltfValues& source, const char* key, double highest, const std::string& place,
              Warnings& warnings) {
  const GltfValues extras = source.object("extras").object("foveola");
  if (!extras.has(key)) {
    return 0.0F;
  }
  const double size = extras.number(key, -1.0);
  const double limited = std::clamp(size, 0.0, highest);
  if (limited != size) {
    warnings.add("the size of a light is clamped to its range",
                 fmt::format("{}.extras.foveola.{}", place, key));
  }
  return static_cast<float>(limited);
}

void read_size(const GltfValues& source, const std::string& place, PunctualLight& light,
               Warnings& warnings) {
  if (light.kind == PunctualLight::Kind::directional) {
    light.angular_radius_rad =
        size_of(source, "angular_radius_rad", largest_angular_radius_rad, place, warnings);
  } else {
    light.radius_m = size_of(source, "radius_m", largest_radius_m, place, warnings);
  }
}

}  // namespace

LightUnits light_units_of(std::string_view generator) {
  constexpr Version first_photometric = {3, 4, 40};
  const std::optional<Version> version = blender_exporter_version(generator);
  return version && *version >= first_photometric ? LightUnits::photometric
                                                  : LightUnits::radiometric;
}

PunctualLight::ConeEdge cone_edge_of(std::string_view generator) {
  constexpr Version first_without_cosine = {4, 0, 0};
  const std::optional<Version> version = blender_exporter_version(generator);
  if (!version) {
    return PunctualLight::ConeEdge::squared;
  }
  return *version < first_without_cosine ? PunctualLight::ConeEdge::smooth_times_cosine
                                         : PunctualLight::ConeEdge::smooth;
}

double cycles_inner_cone_rad(double inner_rad, double outer_rad) {
  const double blend = 1.0 - inner_rad / outer_rad;
  return std::acos(std::lerp(std::cos(outer_rad), 1.0, blend));
}

std::vector<PunctualLight> read_lights(const GltfModel& model,
                                       const std::vector<PlacedItem>& lights, const DVec3& origin,
                                       std::optional<LightUnits> units, Warnings& warnings) {
  const std::string generator = model.root().object("asset").text("generator");
  const LightUnits meant = units.value_or(light_units_of(generator));
  const PunctualLight::ConeEdge edge = cone_edge_of(generator);
  const GltfValues sources = model.root().extension("KHR_lights_punctual");
  std::vector<PunctualLight> result;
  for (const PlacedItem& item : lights) {
    const GltfValues source = sources.item("lights", item.index);
    const GltfNode& node = model.nodes[static_cast<std::size_t>(item.placement.node)];
    const DMat4& world_from_local = item.placement.world_from_local;
    const std::string place = fmt::format("lights[{}]", item.index);
    const std::optional<PunctualLight::Kind> kind = kind_of(source.text("type"));
    if (!kind) {
      warnings.add(
          fmt::format("lights of type \"{}\" are left out", sanitised(source.text("type"))), place);
      continue;
    }
    PunctualLight light;
    light.name = sanitised(node.name.empty() ? source.text("name") : node.name);
    light.kind = *kind;
    light.intensity = intensity_of(source, meant, place, warnings);
    light.position = Vec3(DVec3(world_from_local[3]) - origin);
    if (source.number("range", 0.0) > 0.0) {
      warnings.add(
          "the range of a light is ignored: its light falls off with the square of the distance",
          place);
    }
    read_size(source, place, light, warnings);
    if (light.kind == PunctualLight::Kind::spot) {
      read_cone(source.object("spot"), edge, place, light, warnings);
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
  if (!units && meant == LightUnits::photometric && !result.empty()) {
    warnings.add(
        "the lights are divided by 683 lm/W, since Blender's exporter writes them in lux and "
        "candela, unlike emission; if it was set to \"Unitless\" or \"Raw\", give --light-units "
        "radiometric");
  }
  return result;
}

}  // namespace foveola
