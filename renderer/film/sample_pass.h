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

/// The points [first, first + count) of the Sobol sequence that is scrambled by `seed`.
struct SobolRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint32_t seed = 0;
};

/// Keeps its buffers from pass to pass.
class SamplePass {
 public:
  /// Writes the radiance of each job, as PathTracer::trace.
  using Trace = std::function<void(std::span<const SampleJob> jobs, std::span<Rgb> radiance)>;

  /// May move view samples, or take some away, before they are traced.
  using Adjust = std::function<void(std::vector<ViewSample>& samples)>;

  /// Sends `points` through an aimed sampler and `trace` into the film; returns what the film
  /// dropped. Neither the number of threads nor, without `adjust`, how a range is cut into passes
  /// changes the film.
  std::vector<DroppedSample> run(const ViewSampler& sampler, const SobolRange& points,
                                 const Trace& trace, EquirectFilm& film, const Workers& workers,
                                 const Adjust& adjust = {});

 private:
  std::vector<Vec2> points_;
  std::vector<ViewSample> samples_;
  NumberedBatch batch_;
  std::vector<Rgb> radiance_;
};

}  // namespace foveola
