// One pass of a progressive render: points become directions, the tracer's jobs, the film's means.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Where a render's random numbers come from.
enum class RandomNumbers {
  low_discrepancy,  ///< Sobol sequences, as shipped
  independent,      ///< each sample's are independent of all others'
};

/// The points [first, first + count) of the pattern that `seed` makes: of a scrambled Sobol
/// sequence, or independent ones.
struct PointRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint32_t seed = 0;
  RandomNumbers numbers = RandomNumbers::low_discrepancy;
  /// Columns and rows of cells that are visited in rounds, each once in a round, so that their
  /// counts differ by one at most. `numbers` then has no effect. 0: no cells.
  IVec2 cells{0};
  /// Samples are weighed by the inverse of the sampler's density within each pixel, whose mean is
  /// then that of its area; unless the density varies too little for that to matter.
  bool weighs_within_pixels = true;
};

/// Keeps its buffers from pass to pass.
class SamplePass {
 public:
  /// Writes the radiance of each job, as PathTracer::trace.
  using Trace = std::function<void(std::span<const SampleJob> jobs, std::span<Rgb> radiance)>;

  /// May take some view samples away before they are traced; may move them where samples are not
  /// weighed.
  using Adjust = std::function<void(std::vector<ViewSample>& samples)>;

  /// Sends `points` through an aimed sampler and `trace` into the film; returns what the film
  /// dropped. The number of threads does not change the film; nor, with a Sobol sequence and
  /// without `adjust`, does how a range is cut into passes.
  std::vector<DroppedSample> run(const ViewSampler& sampler, const PointRange& points,
                                 const Trace& trace, EquirectFilm& film, const Workers& workers,
                                 const Adjust& adjust = {});

 private:
  std::vector<Vec2> points_;
  std::vector<ViewSample> samples_;
  NumberedBatch batch_;
  std::vector<Rgb> radiance_;
  std::vector<float> weights_;
};

}  // namespace foveola
