// Next-event estimation's view of a scene: where light comes from, and how likely it is drawn.
#pragma once

#include <optional>

#include "renderer/scene/scene.h"
#include "renderer/trace/environment_light.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/triangle_lights.h"

namespace foveola {

/// Light that arrives at a point if nothing is in the way.
struct LightSample {
  Vec3 direction{0.0F};  ///< unit length, towards the light
  float pdf = 0.0F;      ///< per steradian
  Rgb radiance{0.0F};
  Ray shadow_ray;  ///< from the point to the light
};

/// Emissive triangles and the environment. Which of the two is drawn follows their power (the
/// environment's through the disc of the scene's bounding sphere), but each gets a quarter at
/// least: power knows nothing of walls.
class Lights {
 public:
  /// The scene must outlive this object.
  explicit Lights(const Scene& scene);

  /// Nothing shines: every radiance is zero.
  bool empty() const { return triangles_.empty() && !environment_; }

  /// Empty if the light drawn does not shine towards `receiver`. u_kind in [0, 1); u_choice, u in
  /// the unit square. Not to be called when empty().
  std::optional<LightSample> sample(const Vec3& receiver, float u_kind, const Vec2& u_choice,
                                    const Vec2& u) const;

  /// With which density per steradian sample() would have drawn the point that a ray hit.
  /// distance: in metres; cosine: of the angle between the ray and the surface's normal.
  float triangle_pdf(const Hit& hit, float distance, float cosine) const;

  /// What arrives from infinity; black without an environment. direction: unit length.
  Rgb environment_radiance(const Vec3& direction) const;
  /// With which density per steradian sample() would have drawn this direction.
  float environment_pdf(const Vec3& direction) const;

 private:
  std::optional<LightSample> sample_triangle(const Vec3& receiver, const Vec2& u_choice,
                                             const Vec2& u) const;
  std::optional<LightSample> sample_environment(const Vec3& receiver, const Vec2& u) const;

  TriangleLights triangles_;
  std::optional<EnvironmentLight> environment_;  ///< empty where it gives no light
  float environment_probability_ = 0.0F;
};

}  // namespace foveola
