#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/commands/bench/bench_commands.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/film/equirect_film.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

constexpr int film_width = 2048;
constexpr int film_height = 1024;
constexpr std::uint64_t samples_in_all = std::uint64_t{1} << 23;
constexpr std::array ring_ends_deg = {0.5,  1.0,  2.0,  3.0,  4.0,   5.0,   5.79, 7.5,
                                      10.0, 12.5, 15.0, 20.0, 25.0,  30.0,  40.0, 50.0,
                                      60.0, 70.0, 80.0, 90.0, 120.0, 150.0, 180.0};

/// The pixels with centres in a ring.
struct Ring {
  double end_deg = 0.0;
  double square_degrees = 0.0;
  double counted = 0.0;
  double stated = 0.0;  ///< samples expected by the method's stated density
};

/// Midpoints along a side of a pixel for integrating a density: many where it is steep.
int midpoints(double eccentricity_deg) {
  return eccentricity_deg < 3.0 ? 16 : eccentricity_deg < 10.0 ? 4 : 2;
}

/// The solid angle of a pixel, and the integral of the stated density over it.
struct PixelIntegral {
  double sr = 0.0;
  double stated = 0.0;
};

PixelIntegral integrate(const ViewSampler& sampler, int x, int y, int n) {
  PixelIntegral sum;
  const double cell =
      2.0 * std::numbers::pi * std::numbers::pi / film_width / film_height / (n * n);
  for (int i = 0; i < n * n; ++i) {
    const double u = (x + (i % n + 0.5) / n) / film_width;
    const double v = (y + (i / n + 0.5) / n) / film_height;
    const double sr = cell * std::sin(std::numbers::pi * v);
    sum.sr += sr;
    sum.stated += sr * sampler.density_per_sr(direction_from_equirect(Vec2(u, v)));
  }
  return sum;
}

std::vector<Ring> measure(const ViewSampler& sampler, const Vec3& gaze) {
  constexpr std::uint64_t per_pass = std::uint64_t{1} << 20;
  const Workers workers;
  const Scene nothing;  // sample positions depend on no scene, and none is traced
  const PathTracer tracer(nothing, workers);
  ProgressiveRender render(tracer, {.film_size = {film_width, film_height}}, workers);
  render.begin_pattern(1);
  while (render.points_drawn() < samples_in_all) {
    render.pass_over(sampler, per_pass);
  }
  std::vector<Ring> rings =
      transformed(ring_ends_deg, [&](const double end_deg) { return Ring{.end_deg = end_deg}; });
  for (int y = 0; y < film_height; ++y) {
    for (int x = 0; x < film_width; ++x) {
      const Vec3 middle =
          direction_from_equirect(Vec2((x + 0.5) / film_width, (y + 0.5) / film_height));
      const double e = degrees(angle_between(middle, gaze));
      const auto found = std::lower_bound(ring_ends_deg.begin(), ring_ends_deg.end() - 1, e);
      Ring& ring = rings[static_cast<std::size_t>(found - ring_ends_deg.begin())];
      const PixelIntegral pixel = integrate(sampler, x, y, midpoints(e));
      ring.square_degrees += pixel.sr * degrees(1.0) * degrees(1.0);
      ring.stated += pixel.stated * static_cast<double>(samples_in_all);
      ring.counted += render.film().sample_count(x, y);
    }
  }
  return rings;
}

/// Prints the number of samples per square degree in rings around the gaze, counted on a film,
/// beside the method's stated density, as a table or as JSON. Throws Error for an invalid text.
void print_density(const std::string& method, bool as_json) {
  const Vec3 gaze = direction_from({.azimuth_rad = 0.2, .elevation_rad = -0.1});
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport({}, FieldOfView{}), .gaze = gaze});
  nlohmann::json list = nlohmann::json::array();
  if (!as_json) {
    print_text("{}: {} samples on a film of {}x{}\n", method, samples_in_all, film_width,
               film_height);
    print_text("{:>16} {:>12} {:>16} {:>16} {:>8}\n", "degrees from", "samples",
               "per square degree", "stated", "ratio");
  }
  double begin_deg = 0.0;
  for (const Ring& ring : measure(*sampler, gaze)) {
    const double counted = ring.counted / ring.square_degrees;
    const double stated = ring.stated / ring.square_degrees;
    if (as_json) {
      list.push_back({{"from_deg", begin_deg},
                      {"to_deg", ring.end_deg},
                      {"samples", ring.counted},
                      {"samples_per_square_degree", counted},
                      {"stated_per_square_degree", stated}});
    } else {
      print_text("{:>7.2f}..{:<7.2f} {:>12.0f} {:>16.2f} {:>16.2f} {:>8}\n", begin_deg,
                 ring.end_deg, ring.counted, counted, stated,
                 stated > 0.0 ? fmt::format("{:.4f}", counted / stated) : "");
    }
    begin_deg = ring.end_deg;
  }
  if (as_json) {
    print_text("{}\n", nlohmann::json{{"method", method}, {"rings", list}}.dump(2));
  }
}

/// Writes an image of weights for the methods that read one.
void write_weights(const std::filesystem::path& path) {
  RgbImage image(1024, 512);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = Rgb(unit_float(mix(static_cast<std::uint32_t>(i))));
  }
  write_image(path, image, 0.0);
}

struct Measured {
  std::string name;
  Median median;
  std::string unit;
};

/// The median time of a call, without the `prepare` before each.
Median median_s(
    const std::function<void()>& call, const std::function<void(int run)>& prepare = [](int) {}) {
  constexpr int runs = 31;
  const SteadyClock clock;
  std::vector<double> times_s;
  for (int run = 0; run < runs; ++run) {
    prepare(run);
    const Nanoseconds start = clock.now();
    call();
    times_s.push_back(seconds(clock.now() - start));
  }
  return median_of(std::move(times_s));
}

/// The points from `first` on.
std::vector<Vec2> points(std::uint64_t first, std::size_t count) {
  std::vector<Vec2> result;
  for (std::uint64_t i = first; i < first + count; ++i) {
    result.push_back(sobol_2d(i, 1));
  }
  return result;
}

void aim_at(const AzimuthElevation& gaze, ViewSampler& sampler) {
  sampler.aim({.viewport = Viewport({}, FieldOfView{}), .gaze = direction_from(gaze)});
}

std::unique_ptr<ViewSampler> aimed(const std::string& method) {
  std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  aim_at({.azimuth_rad = 0.2, .elevation_rad = -0.1}, *sampler);
  return sampler;
}

Measured sampler_cost(const std::string& method) {
  const std::vector<Vec2> square = points(0, 1 << 16);
  std::vector<ViewSample> samples(square.size());
  const std::unique_ptr<ViewSampler> sampler = aimed(method);
  const Median time_s = median_s([&] { sampler->sample(square, samples); });
  constexpr double ns_per_s = 1e9;
  return {method, time_s * (ns_per_s / static_cast<double>(square.size())),
          "ns per sample, one core"};
}

/// Whether a film continues, or is cleared before every batch, with a new gaze.
enum class FilmUse { continued, cleared_first };

/// Cost of numbering and adding a batch of FV's samples, pyramid included. No two batches share a
/// point, so pixels away from the gaze are new to the film.
Measured film_cost(int width, int height, FilmUse use, const Workers& workers) {
  constexpr std::size_t batch_size = 10'000;
  std::vector<ViewSample> samples(batch_size);
  const std::unique_ptr<ViewSampler> sampler = aimed("fv");
  const std::vector<Rgb> radiance(batch_size, Rgb(1.0F));
  EquirectFilm film(width, height);
  NumberedBatch batch;
  const auto prepare = [&](int run) {
    if (use == FilmUse::cleared_first) {
      constexpr double golden_angle_rad = 2.399963;
      aim_at({.azimuth_rad = run * golden_angle_rad, .elevation_rad = 0.3 * std::sin(run)},
             *sampler);
    }
    sampler->sample(points(static_cast<std::uint64_t>(run) * batch_size, batch_size), samples);
  };
  const auto use_film = [&] {
    if (use == FilmUse::cleared_first) {
      film.clear();
    }
    film.number(samples, batch, workers);
    film.add(batch, radiance, workers);
  };
  const Median time_s = median_s(use_film, prepare);
  constexpr double ms_per_s = 1e3;
  return {fmt::format("film of {}x{}{}", width, height,
                      use == FilmUse::cleared_first ? ", cleared, another gaze" : ""),
          time_s * ms_per_s,
          fmt::format("ms for {} samples, {} threads", batch_size, workers.threads())};
}

std::vector<Measured> cost_of_each() {
  std::vector<Measured> measured;
  for (const char* method : {"od", "vp", "vp-rect", "fv", "fv-paper", "fv:acuity=guenter",
                             "fv:acuity=watson", "pointer", "crop", "hybrid:0.9*fv+0.1*od"}) {
    measured.push_back(sampler_cost(method));
  }
  const ScratchFolder folder;
  const std::filesystem::path weights = folder / "weights.exr";
  write_weights(weights);
  for (const std::string method : {"fv-map", "mask"}) {
    measured.push_back(sampler_cost(fmt::format("{}:file={}", method, weights.string())));
    measured.back().name = method + " of 1024x512 pixels";
  }
  return measured;
}

/// methods: empty for one of each.
void run(const std::vector<std::string>& methods, bool as_json) {
  std::vector<Measured> measured;
  if (methods.empty()) {
    measured = cost_of_each();
  }
  for (const std::string& method : methods) {
    measured.push_back(sampler_cost(method));
  }
  const Workers workers;
  for (const int width : {1024, 4096, 8192}) {
    for (const FilmUse use : {FilmUse::continued, FilmUse::cleared_first}) {
      measured.push_back(film_cost(width, width / 2, use, workers));
    }
  }
  if (!as_json) {
    for (const Measured& figure : measured) {
      print_text("{:<40} {:8.2f} {}\n", figure.name, figure.median.value, figure.unit);
    }
    return;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measured& figure : measured) {
    nlohmann::ordered_json entry = {{"name", figure.name}, {"unit", figure.unit}};
    entry.update(json_of(figure.median));
    list.push_back(entry);
  }
  nlohmann::ordered_json json = bench_facts();
  json["figures"] = std::move(list);
  print_text("{}\n", json.dump(2));
}

}  // namespace

void add_bench_sampling(CLI::App& bench) {
  const auto methods = std::make_shared<std::vector<std::string>>();
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "sampling", "Measure the cost of drawing view samples and adding them to the film: medians");
  const auto density = std::make_shared<std::string>();
  command->add_option(
      "--density", *density,
      "Print this method's sample density instead: counted and stated, in rings around the gaze");
  command->add_option("METHOD", *methods,
                      "Methods, as render's --method (default: one of each kind)");
  command->add_flag("--json", *as_json, "Print the figures as JSON");
  command->footer("Example: foveola bench sampling fv fv:acuity=guenter,cutoff=60");
  command->callback([methods, density, as_json] {
    if (density->empty()) {
      run(*methods, *as_json);
    } else {
      print_density(*density, *as_json);
    }
  });
}

}  // namespace foveola
