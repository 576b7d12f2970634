// Radiance and small pictures whose noise is known, so that they can be compared with each other
// and with answers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "renderer/stability/checks.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {

/// A mean of each channel. Not a number where a sample was not finite.
struct RadianceEstimate {
  DVec3 mean{0.0};
  DVec3 standard_error{0.0};
  std::uint64_t samples = 0;
};

/// The mean of independent batches of equal size, its standard error from their scatter.
RadianceEstimate mean_of_batches(const std::vector<DVec3>& batch_means);

/// Five standard errors: with 64 batches a true mean is farther off once in 200000 times.
constexpr double standard_errors_allowed = 5.0;

/// The unit direction of a point of the unit square, uniform over the sphere.
Vec3 direction_all_around(const Vec2& u);
/// One sample of each of `count` pixels in directions all around.
std::vector<SampleJob> jobs_all_around(std::uint32_t count, std::uint32_t seed);

/// A bundle of rays whose mean radiance is wanted.
struct Measurement {
  Vec3 viewpoint{0.0F};
  /// A unit direction for a point of the unit square.
  std::function<Vec3(const Vec2&)> direction;
  int max_depth = TraceSettings{}.max_depth;
  double expected = 1.0;  ///< what the tolerance is relative to
};

/// A bundle of one ray. direction need not have unit length.
Measurement along(const Vec3& viewpoint, const Vec3& direction, int max_depth, double expected);

/// Samples until five standard errors of every channel are below the effort's tolerance, or the
/// most samples are spent. Batches are pixels, whose random numbers are independent.
RadianceEstimate measure(const PathTracer& tracer, const Measurement& measurement,
                         const StabilityRun& run);

/// The largest deviation from `expected` over the channels, in percent of it. It must stay within
/// five standard errors and within the tolerance. exactness: relative, of the expected value, for
/// what floats and tessellation leave open.
StabilityFigure deviation(std::string name, const RadianceEstimate& estimate, const DVec3& expected,
                          double exactness, double tolerance);

/// How far the estimate lies above `limit`, in percent of it, five standard errors allowed.
StabilityFigure excess(std::string name, const RadianceEstimate& estimate, double limit,
                       double exactness, double tolerance);

/// The figure that is closest to its bound or farthest beyond it, under a new name; its details
/// say which it was, and of how many. There must be at least one.
StabilityFigure worst_of(std::string name, const std::vector<StabilityFigure>& figures);

struct PictureSettings {
  int block = 8;      ///< pixels along a side; divides the effort's width and height
  int max_depth = 6;  ///< less than a render's: both of two pictures compared have the same
  std::uint32_t seed = 0;
};

/// The mean radiance of each block, row by row from the top left, in the convention of the film.
/// Every pixel gets the effort's samples (32 at least), uniformly over its area.
std::vector<RadianceEstimate> render_blocks(const PathTracer& tracer, const Vec3& viewpoint,
                                            const PictureSettings& settings,
                                            const StabilityRun& run);

/// The largest difference between equal blocks of two pictures, in standard errors of that
/// difference. exactness: relative to the block's mean, what is forgiven beside noise.
StabilityFigure picture_difference(std::string name, const std::vector<RadianceEstimate>& picture,
                                   const std::vector<RadianceEstimate>& reference,
                                   double exactness);

}  // namespace foveola
