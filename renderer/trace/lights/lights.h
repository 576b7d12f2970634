// Next-event estimation's view of a scene: where light comes from, and how likely it is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "renderer/scene/scene.h"
#include "renderer/trace/lights/environment_light.h"
#include "renderer/trace/lights/learned_lights.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/lights/local_lights.h"
#include "renderer/trace/lights/suns.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

/// Light that arrives at a point if nothing is in the way: f |cos| radiance / pdf estimates what is
/// scattered. A ray may meet by chance what a sample was drawn from, so both are to be weighed by
/// their densities; but no ray meets a delta light, and its samples count in full.
///
/// Number: float, or Floats.
template <typename Number>
struct LightSampleOf {
  Vec3Of<Number> direction{};  ///< unit length, towards the light
  Number pdf{};  ///< per steradian; without size: the probability that it was drawn; 0: no light
  Vec3Of<Number> radiance{};  ///< without size: the irradiance that it gives head-on
  MaskOf<Number> is_delta{};  ///< a light without size
  Vec3Of<Number> to_light{};  ///< the shadow ray's direction from the shading point
  Number t_max{};             ///< where the shadow ray ends; infinite for distant lights
};
using LightSample = LightSampleOf<float>;
using LightSamples = LightSampleOf<Floats>;

/// The random numbers of eight shading points: u_kind, u_choice and u of Lights::sample().
struct LightNumbers {
  FloatLanes kind;
  Vec2Lanes choice;
  Vec2Lanes point;
};

/// Three kinds of light: the environment, the suns (directional lights), and those in the scene
/// (emissive triangles, points, spots). Of the n kinds that a scene has, each is drawn with the
/// probability 1 / (2 n) + its share of the power / 2, for power knows nothing of walls. The power
/// of what is infinitely far is what falls through the disc of the scene's bounding sphere. Of a
/// uniform selection a kind has as large a share as of the lights.
class Lights {
 public:
  /// The scene must outlive this object. max_in_table: see LocalLights.
  explicit Lights(const Scene& scene, const LightSampling& sampling = {},
                  std::size_t max_in_table = LightChoice::default_max_in_table);

  /// Nothing shines: every radiance is zero.
  bool empty() const { return empty_; }

  /// Which of several surfaces in one place is seen, and lights.
  const CoincidentSurfaces& coincident() const { return local_.coincident(); }

  /// u_kind decides something.
  bool has_several_kinds() const {
    return (environment_ ? 1 : 0) + (suns_.empty() ? 0 : 1) + (local_.empty() ? 0 : 1) > 1;
  }

  /// u_choice decides something.
  bool has_several_of_a_kind() const { return suns_.size() > 1 || local_.size() > 1; }

  /// Empty if the light drawn does not reach the shading point, or if what shines is found by rays
  /// only (see TriangleLights). u_kind in [0, 1); u_choice, u in the unit square.
  std::optional<LightSample> sample(const ShadingPoint& shading_point, float u_kind,
                                    const Vec2& u_choice, const Vec2& u) const;

  /// From which light sample() draws as long as nothing is learned; nothing of it has arrived yet.
  LightOutcome outcome(const ShadingPoint& shading_point, float u_kind, const Vec2& u_choice,
                       const Vec2& u) const;

  /// There is something to learn.
  bool can_learn() const {
    return has_several_kinds() || draws_bright_sky_ || local_.tree() != nullptr;
  }
  /// From now on light is drawn by what arrived in these outcomes, and shading points are to say
  /// their region; unless one of them says that it would hardly help. To be called once.
  void learn(std::span<const LightOutcome> outcomes);

  /// For ShadingPoint::region. normal: of the geometry.
  std::uint32_t region_of(const Vec3& position, const Vec3& normal) const {
    return learned_.region_of(position, normal);
  }
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const {
    return learned_.regions_of(position, normal);
  }

  /// The same for the shading points of some lanes.
  LightSamples sample(const ShadingPoints& shading_points, const LightNumbers& numbers,
                      const LaneMask& lanes) const;

  /// With which density per steradian sample() would have drawn the point that a ray from the
  /// shading point hit; 0 for surfaces that are not sampled. distance: in metres; cosine: of the
  /// angle between the ray and the surface's normal.
  float triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                     float cosine) const;

  /// What arrives from infinity: environment and discs of suns. direction: unit length. The density
  /// is that of samples drawn for the shading point.
  DistantLight distant_light(const ShadingPoint& shading_point, const Vec3& direction) const;

  /// Some suns are discs.
  bool has_sun_discs() const { return suns_.sizeless() < suns_.size(); }
  /// The direction lies in the disc of a sun.
  bool is_in_sun(const Vec3& direction) const { return suns_.at(direction).pdf > 0.0F; }

  /// Rays may meet points and spots.
  bool has_spheres() const { return local_.has_spheres(); }
  /// The lanes whose rays may meet one.
  LaneMask may_meet_sphere(const Vec3s& origin, const Vec3s& direction) const {
    return local_.may_meet_sphere(origin, direction);
  }
  /// Calls visit(PunctualLights::Met) for those on a ray from the shading point, with the density
  /// of sample(), whatever else the ray meets.
  template <typename Visit>
  void visit_spheres(const ShadingPoint& shading_point, const Ray& ray, const Visit& visit) const {
    local_.visit_spheres(shading_point, ray, learned_.kinds(shading_point.region).local,
                         learned_.preferences(shading_point.region), visit);
  }

  /// The points and spots, and the suns, that no ray meets.
  std::size_t sizeless_points() const { return local_.sizeless(); }
  std::size_t sizeless_suns() const { return suns_.sizeless(); }

 private:
  using Sun = std::optional<std::size_t>;  ///< from which a direction was drawn

  KindProbabilities default_probabilities(const Scene& scene, LightSelection selection) const;
  /// What the environment alone says of the direction, as with_suns() takes it.
  DistantLight sky_at(const ShadingPoint& shading_point, const Vec3& direction) const;
  EnvironmentLight::Sample sample_sky(const ShadingPoint& shading_point, const Vec2& u) const;
  /// sky: what the environment alone says of the direction. known: see Suns::at().
  DistantLight with_suns(const ShadingPoint& shading_point, const DistantLight& sky,
                         const Vec3& direction, Sun known) const;

  LightKind kind_of(const ShadingPoint& shading_point, float u_kind) const;
  /// probability: with which local lights were drawn.
  template <typename Number>
  static LightSampleOf<Number> from_local(const LocalLightSampleOf<Number>& sample,
                                          const Number& probability);
  std::optional<LightSample> sample_suns(const ShadingPoint& shading_point, const Vec2& u_choice,
                                         const Vec2& u) const;
  /// sky: comes with a direction drawn from it, because asked anew, across a cell's border, its
  /// density may be off by any factor.
  std::optional<LightSample> sample_distant(const ShadingPoint& shading_point,
                                            const Vec3& direction, const DistantLight& sky,
                                            Sun known) const;

  std::optional<EnvironmentLight> environment_;  ///< empty where it gives no light
  Suns suns_;
  LocalLights local_;
  bool empty_;
  bool draws_bright_sky_;  ///< there is an environment, and it is drawn by its brightness
  LearnedLights learned_;
};

}  // namespace foveola
