// What a direction costs, by method.
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

constexpr std::size_t batch = 4096;

std::unique_ptr<ViewSampler> aimed(const std::string& method) {
  constexpr double fov_rad = radians(100.0);
  std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport(head_orientation({}), fov_rad, fov_rad),
                .gaze = direction_from({.azimuth_rad = 0.2, .elevation_rad = -0.1})});
  return sampler;
}

void directions(benchmark::State& state, const std::string& method) {
  const std::unique_ptr<ViewSampler> sampler = aimed(method);
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < batch; ++i) {
    points.push_back(sobol_2d(i, 1));
  }
  std::vector<ViewSample> samples(batch);
  for (auto _ : state) {
    sampler->sample(points, samples);
    benchmark::DoNotOptimize(samples.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch));
}
BENCHMARK_CAPTURE(directions, od, "od");
BENCHMARK_CAPTURE(directions, vp, "vp");
BENCHMARK_CAPTURE(directions, vp_rect, "vp-rect");
BENCHMARK_CAPTURE(directions, fv, "fv");
BENCHMARK_CAPTURE(directions, fv_paper, "fv-paper");
BENCHMARK_CAPTURE(directions, fv_guenter, "fv:acuity=guenter");
BENCHMARK_CAPTURE(directions, fv_watson, "fv:acuity=watson");
BENCHMARK_CAPTURE(directions, pointer, "pointer");
BENCHMARK_CAPTURE(directions, crop, "crop");
BENCHMARK_CAPTURE(directions, hybrid, "hybrid:0.9*fv+0.1*od");

}  // namespace
}  // namespace foveola
