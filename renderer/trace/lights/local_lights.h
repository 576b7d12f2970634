// The lights within the scene: emissive triangles, points and spots.
#pragma once

#include <cstddef>
#include <optional>

#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_choice.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/lights/punctual_lights.h"
#include "renderer/trace/lights/triangle_lights.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

class LocalLights {
 public:
  /// The scene must outlive it. max_in_table: see LightChoice; for the default selection.
  LocalLights(const Scene& scene, const LightSampling& sampling, std::size_t max_in_table);

  /// Whether no light can be drawn.
  bool empty() const { return !choice_; }

  const CoincidentSurfaces& coincident() const { return triangles_.coincident(); }

  /// Whether sample() leaves out some emissive triangles (see TriangleLights), which only rays
  /// find.
  bool has_unlisted() const { return triangles_.has_unlisted(); }

  /// Luminous power, in units of radiance x m^2 x sr.
  double power() const { return power_; }

  bool has_spheres() const { return choice_ && !punctual_.spheres().empty(); }

  /// The lanes whose rays may hit a point's or a spot's sphere.
  LaneMask may_hit_sphere(const Vec3s& origin, const Vec3s& direction) const {
    return punctual_.may_hit(origin, direction);
  }

  /// Number of points and spots of radius 0.
  std::size_t sizeless() const { return punctual_.size() - punctual_.spheres().size(); }

  /// Number of lights with power.
  std::size_t size() const { return size_; }

  /// Null if the lights are too few for a tree.
  const LightTree* tree() const { return choice_ ? choice_->tree() : nullptr; }

  /// nullopt if the light drawn does not reach the shading point. u_choice, u: in the unit square.
  /// preferences: of the tree, or null. Not to be called when empty().
  std::optional<LocalLightSample> sample(const ShadingPoint& shading_point, const Vec2& u_choice,
                                         const Vec2& u,
                                         const LightTree::Preferences* preferences) const;

  /// Chooses a light as sample() does without preferences; nullopt if none can reach the point.
  /// u_choice: in the unit square. Not to be called when empty().
  std::optional<ChosenLight> light_drawn(const ShadingPoint& shading_point,
                                         const Vec2& u_choice) const {
    return choice_->sample(shading_point, u_choice, nullptr);
  }

  /// Returns an empty batch of chosen lights for choose().
  TriangleLights::Drawn make_batch() const { return TriangleLights::Drawn(triangles_); }

  /// Chooses a light for the shading point of a lane. If a batch can sample it, it is added to
  /// `drawn`; otherwise it is sampled at once into `sampled`, as by sample(). Not to be called when
  /// empty().
  enum class Choice { nothing, drawn, sampled };
  Choice choose(const ShadingPoint& shading_point, const Vec2& u_choice, const Vec2& u,
                const LightTree::Preferences* preferences, std::size_t lane,
                TriangleLights::Drawn& drawn, LocalLightSample& sampled) const;

  /// Density, per steradian, of sample() for the point that a ray from the shading point hit; 0 for
  /// surfaces that are not sampled. distance: to the hit, in metres. cosine: between the ray and
  /// the triangle's normal.
  float triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                     float cosine, const LightTree::Preferences* preferences) const;

  /// Calls visit(PunctualLights::SphereHit) for the spheres on a ray from the shading point.
  /// Densities are those of samples, given the probability of this kind of light. Not to be called
  /// when empty().
  template <typename Visit>
  void visit_spheres(const ShadingPoint& shading_point, const Ray& ray, float kind_probability,
                     const LightTree::Preferences* preferences, const Visit& visit) const {
    for (const std::size_t light : punctual_.spheres()) {
      if (auto hit = punctual_.hit(light, ray.origin, ray.direction)) {
        const float probability =
            kind_probability *
            choice_->probability(shading_point, triangles_.size() + light, preferences);
        hit->pdf = probability > 0.0F ? probability * hit->pdf : 0.0F;
        visit(*hit);
      }
    }
  }

 private:
  std::optional<LocalLightSample> sample_of(const ChosenLight& chosen,
                                            const ShadingPoint& shading_point, const Vec2& u) const;

  TriangleLights triangles_;
  PunctualLights punctual_;  ///< numbered after the triangles
  std::optional<LightChoice> choice_;
  double power_ = 0.0;
  std::size_t size_ = 0;
};

}  // namespace foveola
