// One pass of a progressive render: points become directions, the tracer's jobs, the film's means.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/work/parallel.h"
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
};

/// Its three steps are taken in turn, with the tracer between the last two. It keeps its buffers
/// from pass to pass. The number of threads does not change the film; nor, with a Sobol sequence
/// and samples that are left as they were drawn, does how a range is cut into passes.
class SamplePass {
 public:
  /// Sends `points` through an aimed sampler. The caller may take samples away before they are
  /// numbered, and may move them if they are not weighed.
  std::vector<ViewSample>& draw_samples(const ViewSampler& sampler, const PointRange& points,
                                        const Workers& workers);

  /// Returns the jobs of the samples for the tracer, valid until the next pass.
  std::span<const SampleJob> number_samples(EquirectFilm& film, const Workers& workers);

  /// Adds the radiance of each job, as PathTracer::trace gives it; returns what the film dropped.
  /// weighs_by: samples are weighed by the inverse of this sampler's density within each pixel,
  /// whose mean is then that of its area, unless the density varies too little for that to matter.
  /// Null: all samples weigh the same.
  std::vector<DroppedSample> add_radiance(std::span<const Rgb> radiance,
                                          const ViewSampler* weighs_by, EquirectFilm& film,
                                          const Workers& workers);

 private:
  std::vector<Vec2> points_;
  std::vector<ViewSample> samples_;
  NumberedBatch batch_;
  std::vector<float> weights_;
};

}  // namespace foveola
