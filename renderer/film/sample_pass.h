// One pass of a progressive render: points become directions, tracer jobs and film means.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// Source of a render's random numbers.
enum class RandomNumbers {
  low_discrepancy,  ///< Sobol sequences, the default
  independent,      ///< independent for each sample
};

/// The points [first, first + count) of the pattern of `seed`: a scrambled Sobol sequence, or
/// independent points.
struct PointRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint32_t seed = 0;
  RandomNumbers numbers = RandomNumbers::low_discrepancy;
  /// Columns and rows of cells that are each visited once per round, so that their counts differ by
  /// at most one. `numbers` then has no effect. 0: no cells.
  IVec2 cells{0};
};

/// Its three steps are called in order, with the tracer between the last two. Buffers are reused
/// from pass to pass. The film does not depend on the number of threads. With a Sobol sequence and
/// unfiltered samples, it does not depend on a range's division into passes either.
class SamplePass {
 public:
  /// Maps `points` through an aimed sampler. The caller may remove samples before they are
  /// numbered, and may move them if they are not weighted.
  std::vector<ViewSample>& draw_samples(const ViewSampler& sampler, const PointRange& points,
                                        const Workers& workers);

  /// Returns the jobs of the samples for the tracer, valid until the next pass.
  std::span<const SampleJob> number_samples(EquirectFilm& film, const Workers& workers);

  /// Adds the radiance of each job, as from PathTracer::trace; returns the samples dropped by the
  /// film. weighs_by: weights samples by the inverse of this sampler's density within each pixel,
  /// which gives the mean over the pixel's area, unless the density is nearly constant. Null: equal
  /// weights.
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
