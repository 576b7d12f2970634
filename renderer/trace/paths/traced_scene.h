// A scene with all structures for tracing it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/lights/lights.h"
#include "renderer/trace/materials/fast_path_bsdf.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/surface_points.h"

namespace foveola {

/// An object, with the values that are equal for all its hits.
struct TracedObject {
  ObjectView view;
  bool is_unlit = false;
  bool is_thin_transmissive = false;
  bool shines = false;
  bool refracts = false;
  Rgb absorption_per_m{0.0F};    ///< of the solid that it bounds
  bool is_on_fast_path = false;  ///< its vertices are processed eight at a time
  bool is_constant = false;      ///< `layers` hold everywhere: nothing varies them
  FastPathLayers layers{};       ///< without textures
  bool has_normal_map = false;
};

/// Traits that select an object's processing, one bit each.
struct ObjectTraits {
  static constexpr std::uint8_t shines = 1;
  static constexpr std::uint8_t is_thin_transmissive = 2;
  static constexpr std::uint8_t is_on_fast_path = 4;
  static constexpr std::uint8_t has_normal_map = 8;
};

struct TracedScene {
  const Scene& scene;
  RayScene rays;
  Lights lights;
  ScatteringTables tables;
  std::vector<TracedObject> objects;
  std::vector<std::uint8_t> traits;  ///< per object; see ObjectTraits
  bool has_absorption;               ///< whether some solid absorbs
  bool has_other_lobes;              ///< whether a surface has lobes other than Lambertian
  bool is_dark;                      ///< no emission: every radiance is zero
  /// Whether there are sun discs or bright spots, and solids that refract their light.
  bool follows_suns_through_glass;

  /// Absorption per metre of the innermost solid around a place.
  Rgb absorption_at(const Vec3& place) const;

  /// nullopt unless some lights are invisible in mirrors and behind glass.
  std::optional<std::string> warning_of_lights_without_size() const;
  /// nullopt unless scattered rays alone find some lights, by chance: behind solid glass, small
  /// lamps and spheres; behind rough glass, suns and lights without a size, too.
  std::optional<std::string> warning_of_lights_met_by_chance() const;

  TracedScene(const Scene& source, const Workers& workers, const LightSampling& sampling,
              KeptHierarchies* kept);
};

}  // namespace foveola
