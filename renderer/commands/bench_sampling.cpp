#include "renderer/commands/bench_sampling.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/files.h"
#include "renderer/base/print.h"
#include "renderer/base/random.h"
#include "renderer/commands/bench_density.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/commands/medians.h"
#include "renderer/film/equirect_film.h"
#include "renderer/image/image_file.h"

namespace foveola {
namespace {

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

/// The median time of a call; what `prepare` does before each is not counted.
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
          "ns a sample, one core"};
}

/// Whether a film goes on, or is cleared before every batch, where the person looks elsewhere too.
enum class FilmUse { continued, cleared_first };

/// Numbering and adding a batch of FV's samples, pyramid included. No two batches have a point in
/// common, so pixels away from the gaze are new to the film.
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

/// methods: none for one of each.
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
      "sampling", "Measure what drawing view samples and adding them to the film cost: medians");
  const auto density = std::make_shared<std::string>();
  command->add_option("--density", *density,
                      "Print where this method's samples fall instead: counted and stated, in "
                      "rings around the gaze");
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
