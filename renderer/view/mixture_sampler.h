// Combines several view samplers, each with a share of the samples.
#pragma once

#include <memory>
#include <vector>

#include "renderer/view/view_sampler.h"

namespace foveola {

/// Each part gets a stripe of the unit square as wide as its weight, stretched over the whole
/// square, so that each part's pattern stays well distributed.
class MixtureSampler final : public ViewSampler {
 public:
  struct Part {
    double weight = 1.0;  ///< positive; relative to the others
    std::unique_ptr<ViewSampler> sampler;
  };
  /// At least one part.
  explicit MixtureSampler(std::vector<Part> parts);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  void sample_block(std::span<const Vec2> points, std::span<ViewSample> samples) const;

  std::vector<Part> parts_;  ///< weights sum to 1
  std::vector<float> ends_;  ///< ends of the stripes; the last value is infinite
};

}  // namespace foveola
