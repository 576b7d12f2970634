// Samples around where the user points.
#pragma once

#include <optional>

#include "renderer/base/angles.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// A Gaussian around the pointer in planar degrees, cut off.
class PointerSampler final : public ViewSampler {
 public:
  /// radius_deg: the standard deviation along any line through the pointer, positive. cutoff_deg in
  /// (0, 180). fixed: a unit direction that takes the place of the pointer.
  PointerSampler(double radius_deg, double cutoff_deg, const std::optional<Vec3>& fixed);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  double radius_deg_;
  double cutoff_deg_;
  double share_;  ///< part of an uncut Gaussian that lies within the cut-off
  std::optional<Vec3> fixed_;
  Frame around_{Vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace foveola
