#include "renderer/stability/finite_radiance.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/random.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/scene/load_scene.h"
#include "renderer/stability/checks.h"

namespace foveola {
namespace {

constexpr int film_width = 1024;
constexpr int film_height = 512;
constexpr double field_of_view_rad = 1.75;
constexpr std::uint64_t pass_points = 1 << 18;

Viewport viewport_of(const SceneSource& source) {
  return {head_orientation(source.heading), field_of_view_rad, field_of_view_rad};
}

bool is_sound(const Rgb& radiance) {
  return is_finite(radiance) && radiance.r >= 0.0F && radiance.g >= 0.0F && radiance.b >= 0.0F;
}

/// How paths are dealt over scenes and methods.
struct Deal {
  std::uint64_t methods;
  std::uint64_t paths_each;     ///< of a scene with a method
  std::uint64_t paths_a_round;  ///< the last one has the rest

  Deal(const StabilityEffort& effort, std::size_t scenes)
      : methods(published_methods().size()),
        paths_each(std::max<std::uint64_t>(1, effort.scene_paths / (scenes * methods))),
        paths_a_round(effort.round_paths) {}

  std::uint64_t rounds_each() const { return (paths_each + paths_a_round - 1) / paths_a_round; }
};

/// Paths over one scene with one method and one seed.
struct Round {
  std::size_t scene = 0;
  std::size_t method = 0;
  std::uint64_t paths = 0;
  std::uint32_t seed = 0;
};

Round round_of(const Deal& deal, std::uint32_t seed, std::int64_t index) {
  const auto number = static_cast<std::uint64_t>(index);
  const std::uint64_t pair = number / deal.rounds_each();
  const std::uint64_t round = number % deal.rounds_each();
  return {.scene = pair / deal.methods,
          .method = pair % deal.methods,
          .paths = std::min(deal.paths_a_round, deal.paths_each - round * deal.paths_a_round),
          .seed = round == 0 ? seed : mix(seed, static_cast<std::uint32_t>(round))};
}

/// A scene that is loaded.
struct TracedScene {
  const SceneSource& source;
  Scene scene;
  PathTracer tracer;

  TracedScene(const SceneSource& from, const Workers& workers)
      : source(from), scene(load_scene(from)), tracer(scene, workers) {}
};

/// Traces the round's paths through the film as a render does. traced: gets the number of each
/// pass.
FiniteRadiance trace(const TracedScene& traced_scene, const Round& round, const StabilityRun& run,
                     const std::function<void(std::uint64_t)>& traced) {
  const SceneSource& source = traced_scene.source;
  const std::string& method = published_methods()[round.method];
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim(
      {.viewport = viewport_of(source), .gaze = head_orientation(source.heading) * Vec3(0, 0, -1)});
  ProgressiveRender render(
      traced_scene.tracer,
      {.viewpoint = traced_scene.scene.from_file(DVec3(*source.camera_position)),
       .film_size = {film_width, film_height},
       .trace = {.seed = round.seed}},
      run.workers);
  FiniteRadiance found;
  render.observe_samples([&](std::span<const SampleJob> jobs, std::span<const Rgb> radiance) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!is_sound(radiance[i]) && found.faults++ == 0) {
        found.first_fault = fmt::format(
            "{} with {}, pixel {},{} of {}x{}, sample {}, seed {}: ({}, {}, {})", source.name,
            method, jobs[i].pixel % film_width, jobs[i].pixel / film_width, film_width, film_height,
            jobs[i].sample_number, round.seed, radiance[i].r, radiance[i].g, radiance[i].b);
      }
    }
  });
  while (render.points_drawn() < round.paths && !run.stop.stop_requested()) {
    const std::uint64_t points = std::min(pass_points, round.paths - render.points_drawn());
    const std::uint64_t samples = render.advance(*sampler, points).samples;
    found.paths += samples;
    traced(samples);
  }
  return found;
}

}  // namespace

void FiniteRadiance::add(const FiniteRadiance& later) {
  if (faults == 0) {
    first_fault = later.first_fault;
  }
  paths += later.paths;
  faults += later.faults;
}

std::int64_t finite_radiance_rounds(const StabilityEffort& effort, std::size_t scenes) {
  const Deal deal(effort, scenes);
  return static_cast<std::int64_t>(scenes * deal.methods * deal.rounds_each());
}

FiniteRadiance trace_rounds(const StabilityRun& run, const std::vector<SceneSource>& scenes,
                            const ItemRange& rounds) {
  const Deal deal(run.effort, scenes.size());
  std::vector<Round> all;
  std::uint64_t planned = 0;
  for (std::int64_t i = rounds.begin; i < rounds.end; ++i) {
    all.push_back(round_of(deal, run.effort.scene_seed, i));
    planned += all.back().paths;
  }
  FiniteRadiance found;
  std::uint64_t done = 0;
  const auto traced = [&](std::uint64_t paths) {
    done += paths;
    run.progress(static_cast<double>(done) / static_cast<double>(planned));
  };
  std::optional<TracedScene> scene;
  for (const Round& round : all) {
    if (run.stop.stop_requested()) {
      break;
    }
    if (!scene || &scene->source != &scenes[round.scene]) {
      scene.reset();  // two would need twice the memory
      scene.emplace(scenes[round.scene], run.workers);
    }
    found.add(trace(*scene, round, run, traced));
  }
  return found;
}

StabilityFigure figure_of(const FiniteRadiance& found, const std::vector<std::string>& scenes) {
  return {.name = "radiance that is not finite, or negative",
          .measured = static_cast<double>(found.faults),
          .bound = 0.0,
          .unit = fmt::format("of {} paths", found.paths),
          .details =
              found.faults > 0 ? found.first_fault : fmt::format("in {}", fmt::join(scenes, ", "))};
}

std::vector<StabilityFigure> check_finite_radiance(const StabilityRun& run,
                                                   const std::vector<SceneSource>& scenes) {
  if (scenes.empty()) {
    return {};
  }
  std::vector<std::string> names;
  for (const SceneSource& source : scenes) {
    names.push_back(source.name);
  }
  const ItemRange all{.end = finite_radiance_rounds(run.effort, scenes.size())};
  return {figure_of(trace_rounds(run, scenes, all), names)};
}

}  // namespace foveola
