// What the film costs: numbering and adding a batch, and what the display shows of it.
#include <cmath>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "renderer/base/numbers/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

constexpr double fov_rad = radians(100.0);

/// Batches of a method's samples into a film, one after the other.
class FilmFeed {
 public:
  FilmFeed(const char* method, int width, std::size_t batch_size = 10'000, int threads = 1)
      : film(width, width / 2),
        workers(threads),
        sampler_(make_view_sampler(method)),
        points_(batch_size),
        samples_(batch_size),
        radiance_(batch_size, Rgb(1.0F)) {
    sampler_->aim({.viewport = Viewport(head_orientation({}), fov_rad, fov_rad),
                   .gaze = Vec3(0.0F, 0.0F, -1.0F)});
  }

  void draw() {
    for (Vec2& point : points_) {
      point = sobol_2d(next_++, 1);
    }
    sampler_->sample(points_, samples_);
  }

  void add() {
    film.number(samples_, batch_, workers);
    film.add(batch_, radiance_, workers);
  }

  std::int64_t batch_size() const { return static_cast<std::int64_t>(points_.size()); }

  EquirectFilm film;
  Workers workers;

 private:
  std::unique_ptr<ViewSampler> sampler_;
  std::vector<Vec2> points_;
  std::vector<ViewSample> samples_;
  std::vector<Rgb> radiance_;
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
  state.SetItemsProcessed(state.iterations() * feed.batch_size());
}
BENCHMARK_CAPTURE(film_batch, od, "od")->Arg(1024)->Arg(8192);
BENCHMARK_CAPTURE(film_batch, fv, "fv")->Arg(1024)->Arg(8192);

constexpr int view_side = 640;

/// A preview's frames: each has 6100 samples around the gaze.
class PreviewFeed : public FilmFeed {
 public:
  /// After four seconds at 70 Hz.
  explicit PreviewFeed(int threads) : FilmFeed("fv", 4096, 6100, threads) { run(280); }

  void run(int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      draw();
      add();
    }
  }
};

/// One image, by whoever knows nothing of earlier ones.
void film_shown(benchmark::State& state) {
  const PreviewFeed feed(1);
  const Viewport viewport(head_orientation({}), fov_rad, fov_rad);
  const auto unsampled = static_cast<UnsampledPixels>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        viewport_image(feed.film, viewport, view_side, view_side, unsampled, feed.workers));
  }
  state.SetItemsProcessed(state.iterations() * view_side * view_side);
}
BENCHMARK(film_shown)
    ->ArgName("filled")
    ->Arg(static_cast<int>(UnsampledPixels::black))
    ->Arg(static_cast<int>(UnsampledPixels::filled))
    ->Unit(benchmark::kMillisecond);

/// Frames of a preview, without the samples' drawing and tracing. Arguments: threads; how far the
/// head turns from frame to frame, in hundredths of a degree; whether adding to the film counts
/// too.
void frames_shown(benchmark::State& state, const ViewImage& settings) {
  PreviewFeed feed(static_cast<int>(state.range(0)));
  const double turn_rad = radians(0.01 * static_cast<double>(state.range(1)));
  const bool with_film = state.range(2) != 0;
  ViewportResampler resampler(feed.film, settings);
  AzimuthElevation heading;
  const auto show = [&]() -> const RgbImage& {
    return resampler.show(Viewport(head_orientation(heading), fov_rad, fov_rad), feed.workers);
  };
  show();
  for (auto _ : state) {
    state.PauseTiming();
    feed.draw();
    if (!with_film) {
      feed.add();
    }
    heading.azimuth_rad += turn_rad;
    state.ResumeTiming();
    if (with_film) {
      feed.add();
    }
    auto image = show();
    benchmark::DoNotOptimize(image);
  }
}
void black_frames_shown(benchmark::State& state) {
  frames_shown(state, {.width = view_side, .height = view_side, .exposure_stops = 0.0});
}
BENCHMARK(black_frames_shown)
    ->ArgNames({"threads", "turn", "film"})
    ->ArgsProduct({{1, 2}, {0, 50}, {0, 1}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// What the processor draws of a window where there is no graphics card: 60 degrees, 1280x720
/// pixels. Arguments: threads; how far the head turns from frame to frame, in hundredths of a
/// degree; whether it zooms instead, by a part in a hundred.
void window_shown(benchmark::State& state) {
  PreviewFeed feed(static_cast<int>(state.range(0)));
  const double turn_rad = radians(0.01 * static_cast<double>(state.range(1)));
  const double zoom = state.range(2) != 0 ? 1.01 : 1.0;
  DisplayResampler resampler(feed.film, {.width = 1280, .height = 720, .exposure_stops = 0.0});
  AzimuthElevation heading;
  double half_width = std::tan(radians(30.0));
  const auto show = [&]() -> const ByteImage& {
    return resampler.show(Viewport(head_orientation(heading), 2.0 * std::atan(half_width),
                                   2.0 * std::atan(half_width * 0.5625)),
                          feed.workers);
  };
  show();
  for (auto _ : state) {
    state.PauseTiming();
    feed.draw();
    feed.add();
    heading.azimuth_rad += turn_rad;
    half_width = half_width > 1.0 ? 0.3 : half_width * zoom;
    state.ResumeTiming();
    auto image = show();
    benchmark::DoNotOptimize(image);
  }
}
BENCHMARK(window_shown)
    ->ArgNames({"threads", "turn", "zoom"})
    ->Args({1, 0, 0})
    ->Args({2, 0, 0})
    ->Args({1, 50, 0})
    ->Args({2, 50, 0})
    ->Args({2, 0, 1})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foveola
