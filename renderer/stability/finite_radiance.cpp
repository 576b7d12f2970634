#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// Findings about the paths so far.
struct FiniteRadiance {
  std::uint64_t paths = 0;
  std::uint64_t faults = 0;  ///< paths whose radiance is not finite, or negative
  std::string first_fault;   ///< how to reproduce it; empty if there is none
};

/// A scene that is loaded.
struct TracedScene {
  const SceneSource& source;
  Scene scene;
  PathTracer tracer;

  TracedScene(const SceneSource& from, const Workers& workers)
      : source(from), scene(load_scene(from)), tracer(scene, workers) {}
};

/// Traces `paths` paths with the method, through the film as a render does. traced: called after
/// each pass.
void trace(const TracedScene& traced_scene, const std::string& method, std::uint64_t paths,
           const StabilityRun& run, const std::function<void()>& traced, FiniteRadiance& found) {
  const SceneSource& source = traced_scene.source;
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim(
      {.viewport = viewport_of(source), .gaze = head_orientation(source.heading) * Vec3(0, 0, -1)});
  ProgressiveRender render(
      traced_scene.tracer,
      {.viewpoint = traced_scene.scene.from_file(DVec3(*source.camera_position)),
       .film_size = {film_width, film_height},
       .trace = {.seed = run.effort.scene_seed}},
      run.workers);
  render.observe_samples([&](std::span<const SampleJob> jobs, std::span<const Rgb> radiance) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!is_sound(radiance[i]) && found.faults++ == 0) {
        found.first_fault =
            fmt::format("{} with {}, pixel {},{} of {}x{}, sample {}, seed {}: ({}, {}, {})",
                        source.name, method, jobs[i].pixel % film_width, jobs[i].pixel / film_width,
                        film_width, film_height, jobs[i].sample_number, run.effort.scene_seed,
                        radiance[i].r, radiance[i].g, radiance[i].b);
      }
    }
  });
  while (render.points_drawn() < paths && !run.stop.stop_requested()) {
    found.paths +=
        render.advance(*sampler, std::min(pass_points, paths - render.points_drawn())).samples;
    traced();
  }
}

}  // namespace

std::vector<StabilityFigure> check_finite_radiance(const StabilityRun& run,
                                                   const std::vector<SceneSource>& scenes) {
  if (scenes.empty()) {
    return {};
  }
  const std::uint64_t renders = scenes.size() * published_methods().size();
  const std::uint64_t paths_each = std::max<std::uint64_t>(1, run.effort.scene_paths / renders);
  FiniteRadiance found;
  const auto traced = [&] {
    run.progress(static_cast<double>(found.paths) / static_cast<double>(renders * paths_each));
  };
  std::vector<std::string> names;
  for (const SceneSource& source : scenes) {
    names.push_back(source.name);
    const TracedScene scene(source, run.workers);
    for (const std::string& method : published_methods()) {
      trace(scene, method, paths_each, run, traced, found);
    }
  }
  return {{.name = "radiance that is not finite, or negative",
           .measured = static_cast<double>(found.faults),
           .bound = 0.0,
           .unit = fmt::format("of {} paths", found.paths),
           .details = found.faults > 0 ? found.first_fault
                                       : fmt::format("in {}", fmt::join(names, ", "))}};
}

}  // namespace foveola
