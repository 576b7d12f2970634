#include "study/prediction/aim_dependence.h"

#include <algorithm>
#include <array>

namespace foveola::study {
namespace {

/// Returns a direction a little to the right of the aim's gaze, or to its left.
Vec3 beside_gaze(const Aim& aim, float shift) {
  const Vec3 right = glm::normalize(glm::cross(aim.gaze, aim.viewport.head() * Vec3(0, 1, 0)));
  return glm::normalize(aim.gaze + shift * right);
}

constexpr float shift = 0.05F;

}  // namespace

bool follows_gaze(ViewSampler& sampler, const Aim& aim) {
  Aim shifted = aim;
  shifted.gaze = beside_gaze(aim, shift);
  return follows_aim(sampler, aim, shifted);
}

bool follows_aim(ViewSampler& sampler, const Aim& aim, const Aim& other) {
  const std::array places = {aim.gaze, beside_gaze(aim, shift), beside_gaze(aim, -shift)};
  const auto densities = [&](const Aim& aimed) {
    sampler.aim(aimed);
    std::array<double, places.size()> result{};
    std::transform(places.begin(), places.end(), result.begin(),
                   [&](const Vec3& place) { return sampler.density_per_sr(place); });
    return result;
  };
  return densities(aim) != densities(other);
}

}  // namespace foveola::study
