#include "renderer/view/foveated_sampler.h"

#include <utility>

#include "renderer/view/sample_block.h"

namespace foveola {

FoveatedSampler::FoveatedSampler(std::unique_ptr<RadialDistribution> distribution)
    : distribution_(std::move(distribution)), eccentricity_turns_(*distribution_) {}

void FoveatedSampler::aim(const Aim& aim) { around_ = Frame(glm::normalize(aim.gaze)); }

void FoveatedSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  const auto polar = [this](const Vec2& point) {
    return Vec2(eccentricity_turns_(point.x), point.y);
  };
  sample_around(around_, points, polar, samples);
}

double FoveatedSampler::density_per_sr(const Vec3& direction) const {
  return distribution_->density_per_sr(degrees(angle_between(direction, around_.normal)));
}

}  // namespace foveola
