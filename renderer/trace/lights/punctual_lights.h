// Points and spots as light sources: without size, or as spheres that rays meet.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The points and spots among a scene's lights (KHR_lights_punctual). Intensity falls off with the
/// squared distance; a spot's also by
///   clamp((cos(angle to its direction) - cos(outer)) / max(0.001, cos(inner) - cos(outer)), 0,
///   1)^2
/// which is that extension's recommendation, or by what Cycles has in place of the square, if the
/// light says so.
///
/// One with a radius is a sphere that shines evenly with I / (pi r^2), so that its intensity is I
/// from afar; the factor of a spot is that of its centre. A place inside the sphere sees that
/// radiance all around. Rays pass through spheres and gather their radiance. From so far that a
/// sphere counts as a point, samples of it are without size. Lights that are not finite or do not
/// shine are left out.
class PunctualLights {
 public:
  explicit PunctualLights(const Scene& scene);

  std::size_t size() const { return lights_.size(); }

  /// The lights with a radius.
  std::span<const std::size_t> spheres() const { return spheres_; }

  /// In the unit of TriangleLights::power.
  double power(std::size_t light) const;
  LightBounds bounds(std::size_t light) const;

  /// Empty if the light does not reach `place`. A sphere's points are uniform in its solid angle.
  /// u: in the unit square.
  std::optional<LocalLightSample> sample(std::size_t light, const Vec3& place, const Vec2& u) const;

  /// A sphere on a ray.
  struct Met {
    float t;  ///< where sample() would end
    Rgb radiance;
    float pdf;  ///< per steradian, of sample() for the ray's origin; infinite: it counts as a point
  };
  /// Empty if the ray does not meet the light's sphere, or that does not shine towards its origin.
  /// direction: unit length.
  std::optional<Met> meet(std::size_t light, const Vec3& origin, const Vec3& direction) const;

  /// The lanes whose rays may meet a sphere.
  LaneMask may_meet(const Vec3s& origin, const Vec3s& direction) const;

 private:
  std::vector<PunctualLight> lights_;
  std::vector<std::size_t> spheres_;
};

}  // namespace foveola
