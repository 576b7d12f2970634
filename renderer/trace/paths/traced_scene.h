// A scene with all that is built for tracing it.
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

/// An object, with what is the same for all its hits.
struct TracedObject {
  ObjectView view;
  bool is_unlit = false;
  bool is_thin_transmissive = false;
  bool shines = false;
  bool refracts = false;
  Rgb absorption_per_m{0.0F};    ///< in the solid that it bounds
  bool is_on_fast_path = false;  ///< its vertices are worked on eight at a time
  bool is_constant = false;      ///< `layers` hold everywhere: no texture, no vertex says otherwise
  FastPathLayers layers{};       ///< without textures
  bool has_normal_map = false;
};

/// What decides how an object's hits are worked on: a bit each.
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
  std::vector<std::uint8_t> traits;  ///< of each object; see ObjectTraits
  bool has_absorption;               ///< some solid absorbs
  bool has_other_lobes;              ///< something scatters otherwise than a Lambertian layer alone
  bool is_dark;                      ///< nothing shines: every radiance is zero
  /// There are suns with a disc, and solids that refract their light.
  bool follows_suns_through_glass;

  /// The absorption per metre at a place: that of the innermost solid around it.
  Rgb absorption_at(const Vec3& place) const;

  /// Empty unless there are lights that no path meets in mirrors or behind glass.
  std::optional<std::string> warning_of_lights_without_size() const;

  TracedScene(const Scene& source, const Workers& workers, const LightSampling& sampling,
              KeptHierarchies* kept);
};

}  // namespace foveola
