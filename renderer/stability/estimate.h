// Estimates of radiance and small pictures with known noise, for comparison with each other and
// with closed forms.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "renderer/stability/checks.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {

/// A mean of each channel; NaN if a sample was not finite.
struct RadianceEstimate {
  DVec3 mean{0.0};
  DVec3 standard_error{0.0};
  std::uint64_t samples = 0;
};

/// The mean of independent batches of equal size, with its standard error from their scatter.
RadianceEstimate mean_of_batches(const std::vector<DVec3>& batch_means);

/// Maximum deviation: with 64 batches a true mean exceeds it once in 200000 times.
constexpr double standard_errors_allowed = 5.0;

/// Returns the unit direction for a point of the unit square, uniform over the sphere.
Vec3 uniform_direction(const Vec2& u);
/// Returns one sample for each of `count` pixels, in directions uniform over the sphere.
std::vector<SampleJob> uniform_jobs(std::uint32_t count, std::uint32_t seed);

/// A bundle of rays whose mean radiance is measured.
struct Measurement {
  Vec3 viewpoint{0.0F};
  /// The unit direction for a point of the unit square.
  std::function<Vec3(const Vec2&)> direction;
  int max_depth = TraceSettings{}.max_depth;
  double expected = 1.0;  ///< expected radiance, to which the tolerance is relative
};

/// Returns a bundle of one ray. direction need not have unit length.
Measurement single_ray(const Vec3& viewpoint, const Vec3& direction, int max_depth,
                       double expected);

/// Samples until five standard errors of every channel are below the effort's tolerance, or until
/// the maximum number of samples. One batch per pixel, since pixels have independent random
/// numbers. After run.stop it returns early, with a larger error.
RadianceEstimate measure(const PathTracer& tracer, const Measurement& measurement,
                         const StabilityRun& run);

/// Returns the maximum deviation from `expected` over the channels, in percent of it. Its bound is
/// five standard errors, at most the tolerance, plus the allowance. rounding_allowance: relative
/// error of floats and tessellation that is accepted.
StabilityFigure deviation(std::string name, const RadianceEstimate& estimate, const DVec3& expected,
                          double rounding_allowance, double tolerance);

/// Returns the excess of the estimate over `limit`, in percent of it, with five standard errors
/// allowed.
StabilityFigure excess(std::string name, const RadianceEstimate& estimate, double limit,
                       double rounding_allowance, double tolerance);

/// Returns the figure closest to its bound or farthest beyond it, under a new name; its details
/// name the figure and their number. At least one figure.
StabilityFigure worst_of(std::string name, const std::vector<StabilityFigure>& figures);

struct PictureSettings {
  int block = 8;      ///< pixels along a side; divides the effort's width and height
  int max_depth = 6;  ///< less than a render's: both of two pictures compared have the same
  std::uint32_t seed = 0;
};

/// Returns the mean radiance of each block, row by row from the top left, in the film's convention.
/// Every pixel gets the effort's samples (32 at least), uniformly over its area. Meaningless after
/// run.stop.
std::vector<RadianceEstimate> render_blocks(const PathTracer& tracer, const Vec3& viewpoint,
                                            const PictureSettings& settings,
                                            const StabilityRun& run);

/// Returns the maximum difference between corresponding blocks of two pictures, in standard errors
/// of that difference. rounding_allowance: accepted besides noise, relative to the block's mean.
StabilityFigure picture_difference(std::string name, const std::vector<RadianceEstimate>& picture,
                                   const std::vector<RadianceEstimate>& reference,
                                   double rounding_allowance);

}  // namespace foveola
