// A fixed map of probability that follows the gaze (Pohl et al. 2016).
#pragma once

#include "renderer/base/piecewise_constant.h"
#include "renderer/view/gaze_frame.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/weight_image.h"

namespace foveola {

/// An image around the gaze in the azimuthal equidistant projection: the distance from its middle
/// is the eccentricity, up is the head's up. Its pixels are alike in planar square degrees.
class MapSampler final : public ViewSampler {
 public:
  /// extent_deg: the eccentricity at half of the image's larger side, in (0, 179]. Pixels that
  /// reach beyond 179 degrees weigh nothing. Throws Error if no other has any weight.
  MapSampler(WeightImage image, double extent_deg);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  int width_;
  int height_;
  double degrees_per_pixel_;
  PiecewiseConstant2D pixels_;
  GazeFrame gaze_;
};

}  // namespace foveola
