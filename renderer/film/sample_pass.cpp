#include "renderer/film/sample_pass.h"

#include "renderer/base/random.h"

namespace foveola {
namespace {

/// Points that one task draws.
constexpr std::size_t point_block = 4096;

}  // namespace

std::vector<DroppedSample> SamplePass::run(const ViewSampler& sampler, const SobolRange& points,
                                           const Trace& trace, EquirectFilm& film,
                                           const Workers& workers, const Adjust& adjust) {
  points_.resize(points.count);
  samples_.resize(points.count);
  workers.for_each_block(points.count, point_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points_[i] = sobol_2d(points.first + i, points.seed);
    }
    sampler.sample(std::span(points_).subspan(begin, end - begin),
                   std::span(samples_).subspan(begin, end - begin));
  });
  if (adjust) {
    adjust(samples_);
  }
  film.number(samples_, batch_, workers);
  radiance_.resize(batch_.jobs.size());
  trace(batch_.jobs, radiance_);
  return film.add(batch_, radiance_, workers);
}

}  // namespace foveola
