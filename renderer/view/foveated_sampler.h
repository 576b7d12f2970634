// FV: samples around a direction, by a distribution of eccentricity and with a uniform azimuth.
#pragma once

#include <memory>

#include "renderer/view/eccentricity_table.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Following a distribution around the gaze.
class FoveatedSampler final : public ViewSampler {
 public:
  explicit FoveatedSampler(std::unique_ptr<RadialDistribution> distribution);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  std::unique_ptr<RadialDistribution> distribution_;
  EccentricityTable eccentricity_turns_;
  Frame around_{Vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace foveola
