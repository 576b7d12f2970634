#include "renderer/view/foveated_sampler.h"

#include <array>
#include <utility>

#include "renderer/view/sample_block.h"

namespace foveola {

FoveatedSampler::FoveatedSampler(std::unique_ptr<RadialDistribution> distribution)
    : distribution_(std::move(distribution)), eccentricity_turns_(*distribution_) {}

void FoveatedSampler::aim(const Aim& aim) { around_ = Frame(glm::normalize(aim.gaze)); }

void FoveatedSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  const auto polar = [this](std::span<const Vec2> block, std::span<Vec2> turns) {
    std::array<double, sample_block_size> roots;
    for (std::size_t i = 0; i < block.size(); ++i) {
      roots[i] = EccentricityTable::root(block[i].x);
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      turns[i] = Vec2(eccentricity_turns_.at_root(roots[i]), block[i].y);
    }
  };
  sample_around(around_, points, polar, samples);
}

double FoveatedSampler::density_per_sr(const Vec3& direction) const {
  return distribution_->density_per_sr(degrees(angle_between(direction, around_.normal)));
}

}  // namespace foveola
