// All lights of a scene, sampled for next-event estimation.
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

/// Unoccluded light at a point: f |cos| radiance / pdf estimates the scattered radiance. Rays may
/// hit the same light by chance, so both are weighted by their densities (multiple importance
/// sampling). No ray hits a delta light: its samples have weight 1.
///
/// Number: float, or Floats.
template <typename Number>
struct LightSampleOf {
  Vec3Of<Number> direction{};  ///< unit length, towards the light
  Number pdf{};  ///< per steradian; for a delta light: the probability of the choice; 0: no light
  Vec3Of<Number> radiance{};  ///< for a delta light: the irradiance at normal incidence
  MaskOf<Number> is_delta{};  ///< a delta light
  Vec3Of<Number> to_light{};  ///< from the shading point along the shadow ray
  Number t_max{};             ///< the shadow ray's end; infinite for distant lights
};
using LightSample = LightSampleOf<float>;
using LightSamples = LightSampleOf<Floats>;

/// The random numbers of eight shading points: u_kind, u_choice and u of Lights::sample().
struct LightNumbers {
  FloatLanes kind;
  Vec2Lanes choice;
  Vec2Lanes point;
};

/// Three kinds of light: the environment, the suns (directional lights), and local lights (emissive
/// triangles, points, spots). Each of a scene's n kinds is drawn with the probability 1 / (2 n) +
/// its share of the power / 2, since power ignores occlusion. The power of an infinitely far light
/// is the flux through the disc of the scene's bounding sphere. For a uniform selection a kind's
/// share is that of the number of lights.
class Lights {
 public:
  /// The scene must outlive this object. max_in_table: see LocalLights.
  explicit Lights(const Scene& scene, const LightSampling& sampling = {},
                  std::size_t max_in_table = LightChoice::default_max_in_table);

  /// Whether the scene has no emission: every radiance is zero.
  bool empty() const { return empty_; }

  /// Resolves coincident surfaces: which is visible and emits.
  const CoincidentSurfaces& coincident() const { return local_.coincident(); }

  /// Whether u_kind matters.
  bool has_several_kinds() const {
    return (environment_ ? 1 : 0) + (suns_.empty() ? 0 : 1) + (local_.empty() ? 0 : 1) > 1;
  }

  /// Whether u_choice matters.
  bool has_several_of_a_kind() const { return suns_.size() > 1 || local_.size() > 1; }

  /// nullopt if the light drawn does not reach the shading point, or if the emission is sampled by
  /// rays only (see TriangleLights). u_kind in [0, 1); u_choice, u in the unit square.
  std::optional<LightSample> sample(const ShadingPoint& shading_point, float u_kind,
                                    const Vec2& u_choice, const Vec2& u) const;

  /// The light of sample() before learning, as an outcome with gain 0.
  LightOutcome outcome(const ShadingPoint& shading_point, float u_kind, const Vec2& u_choice,
                       const Vec2& u) const;

  /// Whether learning can change the probabilities.
  bool can_learn() const {
    return has_several_kinds() || draws_bright_sky_ || local_.tree() != nullptr;
  }
  /// Draws lights as learned from these outcomes, unless part of them shows too little gain.
  /// Shading points must then have their region. To be called once.
  void learn(std::span<const LightOutcome> outcomes);

  /// For ShadingPoint::region. normal: geometric.
  std::uint32_t region_of(const Vec3& position, const Vec3& normal) const {
    return learned_.region_of(position, normal);
  }
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const {
    return learned_.regions_of(position, normal);
  }

  /// The same for the shading points in some lanes.
  LightSamples sample(const ShadingPoints& shading_points, const LightNumbers& numbers,
                      const LaneMask& lanes) const;

  /// Density, per steradian, of sample() for the point that a ray from the shading point hit; 0 for
  /// surfaces that are not sampled. distance: in metres. cosine: of the angle between the ray and
  /// the surface's normal.
  float triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                     float cosine) const;

  /// Radiance from infinity: environment and sun discs, with the density of samples for the shading
  /// point. direction: unit length.
  DistantLight distant_light(const ShadingPoint& shading_point, const Vec3& direction) const;

  /// Whether the environment has bright spots, and is drawn by its brightness.
  bool has_bright_spots() const { return draws_bright_sky_ && environment_->has_bright_spots(); }
  /// Whether some suns are discs, or bright spots of the environment.
  bool has_sun_discs() const { return suns_.sizeless() < suns_.size() || has_bright_spots(); }
  /// Whether the direction lies in one of those.
  bool is_in_sun(const Vec3& direction) const {
    return suns_.at(direction).pdf > 0.0F ||
           (has_bright_spots() && environment_->is_bright(direction));
  }

  /// Whether rays may hit points and spots.
  bool has_spheres() const { return local_.has_spheres(); }
  /// The lanes whose rays may hit one.
  LaneMask may_hit_sphere(const Vec3s& origin, const Vec3s& direction) const {
    return local_.may_hit_sphere(origin, direction);
  }
  /// Calls visit(PunctualLights::SphereHit) for the spheres on a ray from the shading point, with
  /// the density of sample(), also for those behind other hits.
  template <typename Visit>
  void visit_spheres(const ShadingPoint& shading_point, const Ray& ray, const Visit& visit) const {
    local_.visit_spheres(shading_point, ray, learned_.kinds(shading_point.region).local,
                         learned_.preferences(shading_point.region), visit);
  }

  /// Numbers of points and spots, and of suns, that no ray hits.
  std::size_t sizeless_points() const { return local_.sizeless(); }
  std::size_t sizeless_suns() const { return suns_.sizeless(); }

 private:
  using Sun = std::optional<std::size_t>;  ///< the sun that a direction was drawn from

  KindProbabilities default_probabilities(const Scene& scene, LightSelection selection) const;
  /// The environment's radiance and density alone, for with_suns().
  DistantLight sky_at(const ShadingPoint& shading_point, const Vec3& direction) const;
  EnvironmentLight::Sample sample_sky(const ShadingPoint& shading_point, const Vec2& u) const;
  /// sky: the environment's radiance and density in this direction. known: see Suns::at().
  DistantLight with_suns(const ShadingPoint& shading_point, const DistantLight& sky,
                         const Vec3& direction, Sun known) const;

  LightKind kind_of(const ShadingPoint& shading_point, float u_kind) const;
  /// probability: of drawing local lights.
  template <typename Number>
  static LightSampleOf<Number> from_local(const LocalLightSampleOf<Number>& sample,
                                          const Number& probability);
  std::optional<LightSample> sample_suns(const ShadingPoint& shading_point, const Vec2& u_choice,
                                         const Vec2& u) const;
  /// sky: the value that came with the drawn direction. A new evaluation may fall into a
  /// neighbouring cell, whose density may differ by any factor.
  std::optional<LightSample> sample_distant(const ShadingPoint& shading_point,
                                            const Vec3& direction, const DistantLight& sky,
                                            Sun known) const;

  std::optional<EnvironmentLight> environment_;  ///< nullopt where it has no emission
  Suns suns_;
  LocalLights local_;
  bool empty_;
  bool draws_bright_sky_;  ///< whether an environment exists and is drawn by its brightness
  LearnedLights learned_;
};

}  // namespace foveola
