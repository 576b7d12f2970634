// What the film costs: numbering and adding a batch, and what the display shows of it.
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/viewport_image.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

constexpr std::size_t batch_size = 10'000;
constexpr double fov_rad = radians(100.0);

/// Batches of a method's samples into a film, one after the other.
class FilmFeed {
 public:
  FilmFeed(const char* method, int width)
      : film(width, width / 2), sampler_(make_view_sampler(method)) {
    sampler_->aim({.viewport = Viewport(head_orientation({}), fov_rad, fov_rad),
                   .gaze = Vec3(0.0F, 0.0F, -1.0F)});
  }

  void draw() {
    for (std::size_t i = 0; i < batch_size; ++i) {
      points_[i] = sobol_2d(next_++, 1);
    }
    sampler_->sample(points_, samples_);
  }

  void add() {
    film.number(samples_, batch_, workers);
    film.add(batch_, radiance_, workers);
  }

  EquirectFilm film;
  Workers workers{1};

 private:
  std::unique_ptr<ViewSampler> sampler_;
  std::vector<Vec2> points_{batch_size};
  std::vector<ViewSample> samples_{batch_size};
  std::vector<Rgb> radiance_{batch_size, Rgb(1.0F)};
  NumberedBatch batch_;
  std::uint64_t next_ = 0;
};

/// Argument 0: the film's width in pixels.
void film_batch(benchmark::State& state, const char* method) {
  FilmFeed feed(method, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    feed.draw();
    state.ResumeTiming();
    feed.add();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch_size));
}
BENCHMARK_CAPTURE(film_batch, od, "od")->Arg(1024)->Arg(8192);
BENCHMARK_CAPTURE(film_batch, fv, "fv")->Arg(1024)->Arg(8192);

void film_shown(benchmark::State& state) {
  FilmFeed feed("fv", 2048);
  for (int i = 0; i < 50; ++i) {
    feed.draw();
    feed.add();
  }
  const Viewport viewport(head_orientation({}), fov_rad, fov_rad);
  const auto unsampled = static_cast<UnsampledPixels>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        viewport_image(feed.film, viewport, 640, 640, unsampled, feed.workers));
  }
  state.SetItemsProcessed(state.iterations() * 640 * 640);
}
BENCHMARK(film_shown)
    ->ArgName("filled")
    ->Arg(static_cast<int>(UnsampledPixels::black))
    ->Arg(static_cast<int>(UnsampledPixels::filled))
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foveola
