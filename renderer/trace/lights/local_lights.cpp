#include "renderer/trace/lights/local_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace foveola {
namespace {

/// All lights are drawn from the table, however many there are.
constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

}  // namespace

LocalLights::LocalLights(const Scene& scene, const LightSampling& sampling,
                         std::size_t max_in_table)
    : triangles_(scene, sampling.triangles_by_area), punctual_(scene) {
  std::vector<double> powers;
  std::vector<LightBounds> bounds;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    powers.push_back(triangles_.power(i));
    bounds.push_back(triangles_.bounds(i));
  }
  for (std::size_t i = 0; i < punctual_.size(); ++i) {
    powers.push_back(punctual_.power(i));
    bounds.push_back(punctual_.bounds(i));
  }
  power_ = std::accumulate(powers.begin(), powers.end(), 0.0);
  if (!(power_ > 0.0 && std::isfinite(power_))) {
    return;
  }
  const auto has_power = [](double power) { return power > 0.0; };
  size_ = static_cast<std::size_t>(std::ranges::count_if(powers, has_power));
  switch (sampling.selection) {
    case LightSelection::usual:
      choice_.emplace(powers, bounds, max_in_table);
      break;
    case LightSelection::by_power_alone:
      choice_.emplace(powers, bounds, any_number);
      break;
    case LightSelection::uniform:
      std::transform(powers.begin(), powers.end(), powers.begin(),
                     [&](double power) { return has_power(power) ? 1.0 : 0.0; });
      choice_.emplace(powers, bounds, any_number);
      break;
  }
}

std::optional<LocalLightSample> LocalLights::sample(
    const ShadingPoint& shading_point, const Vec2& u_choice, const Vec2& u,
    const LightTree::Preferences* preferences) const {
  const auto chosen = choice_->sample(shading_point, u_choice, preferences);
  return chosen ? sample_of(*chosen, shading_point, u) : std::nullopt;
}

std::optional<LocalLightSample> LocalLights::sample_of(const ChosenLight& chosen,
                                                       const ShadingPoint& shading_point,
                                                       const Vec2& u) const {
  auto sample = chosen.light < triangles_.size()
                    ? triangles_.sample(chosen.light, shading_point.position, u)
                    : punctual_.sample(chosen.light - triangles_.size(), shading_point.position, u);
  if (sample) {
    sample->pdf *= chosen.probability;
  }
  return sample;
}

LocalLights::Choice LocalLights::choose(const ShadingPoint& shading_point, const Vec2& u_choice,
                                        const Vec2& u, const LightTree::Preferences* preferences,
                                        std::size_t lane, TriangleLights::Drawn& drawn,
                                        LocalLightSample& sampled) const {
  const auto chosen = choice_->sample(shading_point, u_choice, preferences);
  if (!chosen) {
    return Choice::nothing;
  }
  if (chosen->light < triangles_.size() &&
      TriangleLights::Drawn::can_draw(triangles_, chosen->light)) {
    drawn.put(lane, triangles_, chosen->light, chosen->probability);
    return Choice::drawn;
  }
  const auto sample = sample_of(*chosen, shading_point, u);
  if (!sample) {
    return Choice::nothing;
  }
  sampled = *sample;
  return Choice::sampled;
}

float LocalLights::triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                                float cosine, const LightTree::Preferences* preferences) const {
  const std::uint32_t triangle = triangles_.index_of(hit);
  if (!choice_ || triangle == TriangleLights::nothing) {
    return 0.0F;
  }
  const float probability = choice_->probability(shading_point, triangle, preferences);
  return probability > 0.0F
             ? probability * triangles_.pdf(triangle, shading_point.position, distance, cosine)
             : 0.0F;
}

}  // namespace foveola
