// Where the samples go: maps from the unit square to directions, each with its stated density.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/view/viewport.h"

namespace foveola {

/// A direction to trace (unit length, world) and its place in the equirect image.
struct ViewSample {
  Vec3 direction{0.0F, 0.0F, -1.0F};
  Vec2 image{0.5F};
};

/// What a sampler is aimed with, once a frame.
struct Aim {
  Viewport viewport;
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world
};

/// One method of choosing directions. The virtual calls are per batch, never per sample.
class ViewSampler {
 public:
  virtual ~ViewSampler() = default;
  virtual void aim(const Aim& aim) = 0;
  /// Maps points of the unit square [0, 1)^2 to samples, one to one. samples.size() ==
  /// points.size().
  virtual void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const = 0;
  /// The probability density of `direction` per steradian; integrates to 1 over the sphere.
  virtual double density_per_sr(const Vec3& direction) const = 0;
};

/// The names that make_view_sampler knows: "od", "vp", "fv".
const std::vector<std::string>& view_sampler_names();

/// od: uniform over the equirect image. vp: uniform over the viewport's plane. fv: following
/// Reddy's acuity around the gaze. Throws Error for any other name. It must be aimed before use.
std::unique_ptr<ViewSampler> make_view_sampler(std::string_view name);

}  // namespace foveola
