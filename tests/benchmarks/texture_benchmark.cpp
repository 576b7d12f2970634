// What a look into a texture costs: in the cache and out of it, finest level and mip levels.
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {
namespace {

Texture noise(int side) {
  std::vector<std::uint8_t> texels;
  const auto count = static_cast<std::uint32_t>(4 * side * side);
  for (std::uint32_t i = 0; i < count; ++i) {
    texels.push_back(static_cast<std::uint8_t>(mix(i)));
  }
  return {side, side, std::move(texels), true, Wrap::repeat, Wrap::repeat};
}

/// Argument 0: texels along a side.
void texture_at_its_finest(benchmark::State& state) {
  const Texture texture = noise(static_cast<int>(state.range(0)));
  std::uint64_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(texture.sample(sobol_2d(i++, 1)));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(texture_at_its_finest)->Arg(64)->Arg(2048);

void texture_between_levels(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const Texture texture = noise(side);
  const float three_texels = 3.0F / static_cast<float>(side);
  std::uint64_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(texture.sample(sobol_2d(i++, 1), three_texels));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(texture_between_levels)->Arg(64)->Arg(2048);

}  // namespace
}  // namespace foveola
