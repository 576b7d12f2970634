// Materials, directions and random numbers that the tests of the BSDF share.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference_bsdf.h"
#include "renderer/base/numbers/random.h"
#include "renderer/trace/materials/bsdf.h"

namespace foveola {

inline Reflectance reflectance_of(const ReferenceMaterial& m) {
  const auto narrow = [](double value) { return static_cast<float>(value); };
  return {.base_color = Rgb(narrow(m.base)),
          .metallic = narrow(m.metallic),
          .roughness = narrow(m.roughness),
          .ior = narrow(m.ior),
          .specular = narrow(m.specular),
          .transmission = narrow(m.transmission),
          .is_solid = m.is_solid,
          .from_inside = m.from_inside,
          .clearcoat = narrow(m.clearcoat),
          .clearcoat_roughness = narrow(m.clearcoat_roughness),
          .sheen_color = Rgb(narrow(m.sheen)),
          .sheen_roughness = narrow(m.sheen_roughness)};
}

/// Red, green and blue, which differ in their colours only.
using ReferenceChannels = std::array<ReferenceMaterial, 3>;

inline Reflectance reflectance_of(const ReferenceChannels& channels) {
  Reflectance reflectance = reflectance_of(channels[0]);
  for (int c = 0; c < 3; ++c) {
    const ReferenceMaterial& m = channels[static_cast<std::size_t>(c)];
    reflectance.base_color[c] = static_cast<float>(m.base);
    reflectance.specular_color[c] = static_cast<float>(m.specular_colour);
    reflectance.sheen_color[c] = static_cast<float>(m.sheen);
  }
  return reflectance;
}

inline ReferenceChannels grey(const ReferenceMaterial& material) {
  return {material, material, material};
}
/// The same in colours of which some channel is strong in each.
inline ReferenceChannels coloured(const ReferenceMaterial& material) {
  ReferenceChannels channels = grey(material);
  constexpr std::array<double, 3> base = {0.9, 0.4, 0.1};
  constexpr std::array<double, 3> specular = {0.3, 0.6, 1.2};
  constexpr std::array<double, 3> sheen = {0.2, 1.0, 0.5};
  for (std::size_t c = 0; c < 3; ++c) {
    channels[c].base = base[c];
    channels[c].specular_colour = specular[c];
    channels[c].brightest_specular_colour = 1.2;
    channels[c].sheen = material.sheen * sheen[c];
    channels[c].brightest_sheen = material.sheen;
  }
  return channels;
}

/// For any roughness, with sheen, and rough solid glass of indices 1.001, 1.3 and 1.5.
inline const ScatteringTables& scattering_tables() {
  static const ScatteringTables made_once = [] {
    std::vector<Material> materials;
    for (const float ior : {1.001F, 1.3F, 1.5F}) {
      Material material;
      material.ior = ior;
      material.transmission = 1.0F;
      material.is_solid = true;
      material.sheen_color = Rgb(1.0F);
      material.metallic_roughness_texture.texture = 0;
      materials.push_back(material);
    }
    return ScatteringTables(materials, Workers(2));
  }();
  return made_once;
}

inline Vec3 direction_of(double cosine) { return Vec3(direction_in_plane(cosine)); }

inline Vec3 uniform_hemisphere(Pcg32& random) {
  const double z = random.uniform();
  const double azimuth = 2.0 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

struct NamedMaterial {
  std::string name;
  ReferenceMaterial material;
};

/// One of each lobe and of each way to combine them, all of base colour `base`.
inline std::vector<NamedMaterial> every_kind(double base, double roughness) {
  std::vector<NamedMaterial> kinds{
      {"metal", {.metallic = 1.0}},
      {"dielectric", {}},
      {"mixture", {.metallic = 0.4}},
      {"dense dielectric", {.ior = 1.3, .specular = 0.7}},
      {"no interface", {.ior = 1.0}},
      {"wall", {.transmission = 1.0}},
      {"half wall", {.metallic = 0.2, .transmission = 0.5}},
      {"glass", {.transmission = 1.0, .is_solid = true}},
      {"glass from inside", {.transmission = 1.0, .is_solid = true, .from_inside = true}},
      {"half glass", {.ior = 1.3, .transmission = 0.5, .is_solid = true, .from_inside = true}},
      {"clearcoat over metal", {.metallic = 1.0, .clearcoat = 1.0}},
      {"rough clearcoat over glass",
       {.transmission = 1.0, .is_solid = true, .clearcoat = 0.7, .clearcoat_roughness = 0.3}},
      {"sheen", {.sheen = 1.0, .sheen_roughness = 0.5}},
      {"all",
       {.metallic = 0.2,
        .transmission = 0.4,
        .clearcoat = 0.5,
        .clearcoat_roughness = 0.2,
        .sheen = 0.5,
        .sheen_roughness = 0.15}},
  };
  for (NamedMaterial& kind : kinds) {
    kind.material.base = base;
    kind.material.roughness = roughness;
  }
  return kinds;
}

}  // namespace foveola
