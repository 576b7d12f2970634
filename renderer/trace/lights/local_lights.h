// The lights that stand in the scene: emissive triangles, points and spots.
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
  /// The scene must outlive this object. max_in_table: see LightChoice; of the usual selection.
  LocalLights(const Scene& scene, const LightSampling& sampling, std::size_t max_in_table);

  /// There is nothing to draw.
  bool empty() const { return !choice_; }

  const CoincidentSurfaces& coincident() const { return triangles_.coincident(); }

  /// Whether something shines that is not drawn (see TriangleLights).
  bool has_unlisted() const { return triangles_.has_unlisted(); }

  /// Luminous, in radiance times square metre times steradian.
  double power() const { return power_; }

  bool has_spheres() const { return choice_ && !punctual_.spheres().empty(); }

  /// The lanes whose rays may meet a point's or a spot's sphere.
  LaneMask may_meet_sphere(const Vec3s& origin, const Vec3s& direction) const {
    return punctual_.may_meet(origin, direction);
  }

  /// Points or spots without size.
  std::size_t sizeless() const { return punctual_.size() - punctual_.spheres().size(); }

  /// Lights that have power.
  std::size_t size() const { return size_; }

  /// Null: there are few, which are not drawn from a tree.
  const LightTree* tree() const { return choice_ ? choice_->tree() : nullptr; }

  /// Empty if the light drawn does not reach the shading point. u_choice, u: in the unit square.
  /// preferences: the tree's, or null. Not to be called when empty().
  std::optional<LocalLightSample> sample(const ShadingPoint& shading_point, const Vec2& u_choice,
                                         const Vec2& u,
                                         const LightTree::Preferences* preferences) const;

  /// The light that sample() draws from without preferences.
  std::optional<ChosenLight> light_drawn(const ShadingPoint& shading_point,
                                         const Vec2& u_choice) const {
    return choice_->sample(shading_point, u_choice, nullptr);
  }

  /// For choose() to put lights into.
  TriangleLights::Drawn nothing_drawn() const { return TriangleLights::Drawn(triangles_); }

  /// Chooses a light for the shading point in a lane. Puts it into `drawn` if that can draw it;
  /// else draws from it, as sample() does.
  enum class Choice { nothing, drawn, sampled };
  Choice choose(const ShadingPoint& shading_point, const Vec2& u_choice, const Vec2& u,
                const LightTree::Preferences* preferences, std::size_t lane,
                TriangleLights::Drawn& drawn, LocalLightSample& sampled) const;

  /// With which density per steradian sample() would have drawn the point that a ray from the
  /// shading point hit; 0 for what is not sampled.
  float triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                     float cosine, const LightTree::Preferences* preferences) const;

  /// Calls visit(PunctualLights::Met) for the spheres on a ray from the shading point. Their
  /// density is that of a sample, where one of this kind of light has the given probability. Not to
  /// be called when empty().
  template <typename Visit>
  void visit_spheres(const ShadingPoint& shading_point, const Ray& ray, float kind_probability,
                     const LightTree::Preferences* preferences, const Visit& visit) const {
    for (const std::size_t light : punctual_.spheres()) {
      if (auto met = punctual_.meet(light, ray.origin, ray.direction)) {
        const float probability =
            kind_probability *
            choice_->probability(shading_point, triangles_.size() + light, preferences);
        met->pdf = probability > 0.0F ? probability * met->pdf : 0.0F;
        visit(*met);
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
