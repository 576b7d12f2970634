// Points and spots as light sources: delta lights, or spheres that rays hit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The points and spots among a scene's lights (KHR_lights_punctual). Intensity falls off with the
/// squared distance; a spot's also by
///   clamp((cos(angle to its direction) - cos(outer)) / max(0.001, cos(inner) - cos(outer)), 0,
///   1)^2 which is that extension's recommendation, or by Cycles' falloff in place of the square,
///   if the light says so.
///
/// A light with a radius is a sphere of uniform radiance I / (pi r^2), which gives intensity I from
/// afar. A spot's factor is evaluated at its centre. Inside the sphere that radiance comes from all
/// directions. Rays pass through spheres and gather their radiance. From far away a sphere is
/// sampled as a delta light. Lights with non-finite values or without emission are left out.
class PunctualLights {
 public:
  explicit PunctualLights(const Scene& scene);

  std::size_t size() const { return lights_.size(); }

  /// The lights with a radius.
  std::span<const std::size_t> spheres() const { return spheres_; }

  /// In the unit of TriangleLights::power().
  double power(std::size_t light) const;
  LightBounds bounds(std::size_t light) const;

  /// nullopt if the light does not reach `place`. Spheres are sampled uniformly in solid angle. u:
  /// in the unit square.
  std::optional<LocalLightSample> sample(std::size_t light, const Vec3& place, const Vec2& u) const;

  /// A ray's hit of a sphere.
  struct SphereHit {
    float t;  ///< end of the shadow ray of sample()
    Rgb radiance;
    float pdf;  ///< per steradian, of sample() from the ray's origin; infinite: counts as a point
  };
  /// nullopt if the ray misses the light's sphere, or if the sphere does not emit towards its
  /// origin. direction: unit length.
  std::optional<SphereHit> hit(std::size_t light, const Vec3& origin, const Vec3& direction) const;

  /// The lanes whose rays may hit a sphere.
  LaneMask may_hit(const Vec3s& origin, const Vec3s& direction) const;

 private:
  std::vector<PunctualLight> lights_;
  std::vector<std::size_t> spheres_;
};

}  // namespace foveola
