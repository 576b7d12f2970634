// What random numbers cost: the points of directions, and the numbers of paths.
#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

void sobol_points(benchmark::State& state) {
  std::uint64_t index = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sobol_2d(index++, 1));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(sobol_points);

void path_numbers_alone(benchmark::State& state) {
  SampleStream stream(1, 2, 3);
  for (auto _ : state) {
    benchmark::DoNotOptimize(stream.next_2d());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(path_numbers_alone);

void path_numbers_side_by_side(benchmark::State& state) {
  SampleStreamColumns<lane_count> columns;
  for (std::size_t i = 0; i < lane_count; ++i) {
    columns.put(i, SampleStream(1, static_cast<std::uint32_t>(i), 3));
  }
  SampleStreams streams = columns.load(0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(streams.next_2d());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lane_count));
}
BENCHMARK(path_numbers_side_by_side);

}  // namespace
}  // namespace foveola
