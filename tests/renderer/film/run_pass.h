// Runs a whole sample pass with a stand-in for the tracer.
#pragma once

#include <vector>

#include "renderer/film/sample_pass.h"

namespace foveola::test {

/// Leaves the drawn samples as they are.
inline constexpr auto keep_samples = [](std::vector<ViewSample>&) {};

/// Draws `points`, lets `adjust` change the samples and `trace` write their radiance, and returns
/// what the film dropped. Samples are weighed by the sampler's density.
template <typename Trace, typename Adjust = decltype(keep_samples)>
std::vector<DroppedSample> run_pass(SamplePass& pass, const ViewSampler& sampler,
                                    const PointRange& points, const Trace& trace,
                                    EquirectFilm& film, const Workers& workers,
                                    const Adjust& adjust = keep_samples) {
  adjust(pass.draw_samples(sampler, points, workers));
  const std::span<const SampleJob> jobs = pass.number_samples(film, workers);
  std::vector<Rgb> radiance(jobs.size());
  trace(jobs, std::span(radiance));
  return pass.add_radiance(radiance, &sampler, film, workers);
}

}  // namespace foveola::test
