#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "renderer/progressive/progressive_render.h"
#include "renderer/stability/checks.h"
#include "renderer/stability/furnished_room.h"

namespace foveola {
namespace {

constexpr int width = 64;
constexpr int height = 32;
constexpr double view_extent_rad = 1.5;
/// One that spreads samples evenly over tiles and one that gathers them in a few.
constexpr std::array<const char*, 2> methods{"od", "fv"};

/// A way to make a picture, on which it must not depend.
struct Manner {
  std::string name;
  int threads = 1;
  std::uint64_t pass = std::numeric_limits<std::uint64_t>::max();  ///< maximum points per pass
  bool stops = false;  ///< after a third, to continue with another tracer
};

FilmImage render(const Scene& scene, const std::string& method, const Manner& manner,
                 std::uint64_t points) {
  const Workers workers(manner.threads);
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport(Quat(1, 0, 0, 0), view_extent_rad, view_extent_rad)});
  const PathTracer tracer(scene, workers);
  ProgressiveRender render(tracer,
                           {.viewpoint = room_viewpoint,
                            .film_size = {width, height},
                            .trace = {.max_depth = 6, .seed = 3}},
                           workers);
  const auto advance_to = [&](std::uint64_t end) {
    while (render.points_drawn() < end) {
      render.advance(*sampler, std::min(manner.pass, end - render.points_drawn()));
    }
  };
  if (manner.stops) {
    advance_to(points / 3);
    const PathTracer another(scene, workers);
    render.use(another);
    advance_to(points);
    return render.film().resolve();
  }
  advance_to(points);
  return render.film().resolve();
}

std::size_t pixels_that_differ(const FilmImage& a, const FilmImage& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const bool same_color = std::memcmp(&a.color.pixels[i], &b.color.pixels[i], sizeof(Rgb)) == 0;
    count += same_color && a.samples[i] == b.samples[i] ? 0 : 1;
  }
  return count;
}

}  // namespace

std::vector<StabilityFigure> check_bit_equality(const StabilityRun& run) {
  const std::vector<Manner> manners = {
      {.name = "2 threads", .threads = 2},
      {.name = "4 threads", .threads = 4},
      {.name = "2 threads, passes of 1000", .threads = 2, .pass = 1000},
      {.name = "4 threads, passes of 7777", .threads = 4, .pass = 7777},
      {.name = "stopped and continued", .threads = 2, .pass = 5000, .stops = true}};
  const Scene scene = room_of_everything();
  const std::uint64_t points =
      static_cast<std::uint64_t>(width) * height * run.effort.picture_samples_per_pixel;
  std::vector<StabilityFigure> figures;
  double done = 0.0;
  for (const char* method : methods) {
    const FilmImage reference = render(scene, method, {.name = "1 thread"}, points);
    StabilityFigure figure{
        .name = fmt::format("{}: pixels that differ on 2 and 4 threads, in other passes, continued",
                            method),
        .measured = 0.0,
        .bound = 0.0,
        .unit = fmt::format("of {}", width * height * manners.size()),
        .details = fmt::format("{} samples, against 1 thread and one pass", points)};
    for (const Manner& manner : manners) {
      if (run.stop.stop_requested()) {
        return figures;
      }
      const std::size_t differing =
          pixels_that_differ(reference, render(scene, method, manner, points));
      figure.measured += static_cast<double>(differing);
      if (differing > 0) {
        figure.details += fmt::format("; {} with {}", differing, manner.name);
      }
      run.progress(++done / static_cast<double>(manners.size() * methods.size()));
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace foveola
