#include "renderer/film/sample_pass.h"

#include "renderer/base/random.h"

namespace foveola {
namespace {

/// Points that one task draws.
constexpr std::size_t point_block = 4096;

/// Draws the points of `range` from the one at `begin` on.
void draw(const PointRange& range, std::size_t begin, std::span<Vec2> points) {
  const std::uint64_t first = range.first + begin;
  if (range.numbers == RandomNumbers::low_discrepancy) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = sobol_2d(first + i, range.seed);
    }
    return;
  }
  Pcg32 generator(range.seed, first);
  for (Vec2& point : points) {
    point.x = unit_float(generator.next());
    point.y = unit_float(generator.next());
  }
}

}  // namespace

std::vector<DroppedSample> SamplePass::run(const ViewSampler& sampler, const PointRange& points,
                                           const Trace& trace, EquirectFilm& film,
                                           const Workers& workers, const Adjust& adjust) {
  points_.resize(points.count);
  samples_.resize(points.count);
  workers.for_each_block(points.count, point_block, [&](std::size_t begin, std::size_t end) {
    const std::span<Vec2> drawn = std::span(points_).subspan(begin, end - begin);
    draw(points, begin, drawn);
    sampler.sample(drawn, std::span(samples_).subspan(begin, end - begin));
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
