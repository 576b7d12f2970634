#include <algorithm>

#include <fmt/format.h>

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

/// What went wrong, and where to find the first case again.
struct Faults {
  std::uint32_t seed = 1;
  std::uint64_t count = 0;
  std::string first;

  void add(const SampleJob& job, const Rgb& radiance, const std::string& where) {
    if (count++ == 0) {
      first = fmt::format("{}, pixel {},{} of {}x{}, sample {}, seed {}: ({}, {}, {})", where,
                          job.pixel % film_width, job.pixel / film_width, film_width, film_height,
                          job.sample_number, seed, radiance.r, radiance.g, radiance.b);
    }
  }
};

bool is_sound(const Rgb& radiance) {
  return is_finite(radiance) && radiance.r >= 0.0F && radiance.g >= 0.0F && radiance.b >= 0.0F;
}

/// Traces `paths` paths through the film as a render does.
void trace_method(const PathTracer& tracer, const Vec3& viewpoint, const SceneSource& source,
                  const std::string& method, std::uint64_t paths, const StabilityRun& run,
                  const std::function<void(std::uint64_t)>& traced, Faults& faults) {
  const std::string where = source.name + " with " + method;
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim(
      {.viewport = viewport_of(source), .gaze = head_orientation(source.heading) * Vec3(0, 0, -1)});
  ProgressiveRender render(tracer,
                           {.viewpoint = viewpoint,
                            .film_size = {film_width, film_height},
                            .trace = {.seed = run.effort.scene_seed}},
                           run.workers);
  render.observe_samples([&](std::span<const SampleJob> jobs, std::span<const Rgb> radiance) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!is_sound(radiance[i])) {
        faults.add(jobs[i], radiance[i], where);
      }
    }
  });
  while (render.points_drawn() < paths && !run.stop.stop_requested()) {
    traced(render.advance(*sampler, std::min(pass_points, paths - render.points_drawn())).samples);
  }
}

}  // namespace

std::vector<StabilityFigure> check_finite_radiance(const StabilityRun& run,
                                                   const std::vector<SceneSource>& scenes) {
  if (scenes.empty()) {
    return {};
  }
  const std::vector<std::string>& methods = published_methods();
  const std::uint64_t paths_each =
      std::max<std::uint64_t>(1, run.effort.scene_paths / (scenes.size() * methods.size()));
  std::uint64_t done = 0;
  const auto traced = [&](std::uint64_t paths) {
    done += paths;
    run.progress(static_cast<double>(done) /
                 static_cast<double>(paths_each * scenes.size() * methods.size()));
  };
  Faults faults{.seed = run.effort.scene_seed, .first = {}};
  std::string names;
  for (const SceneSource& source : scenes) {
    const Scene scene = load_scene(source);
    const PathTracer tracer(scene, run.workers);
    for (const std::string& method : methods) {
      trace_method(tracer, scene.from_file(DVec3(*source.camera_position)), source, method,
                   paths_each, run, traced, faults);
    }
    names += (names.empty() ? "" : ", ") + source.name;
  }
  return {{.name = "radiance that is not finite, or negative",
           .measured = static_cast<double>(faults.count),
           .bound = 0.0,
           .unit = fmt::format("of {} paths", done),
           .details = faults.count > 0 ? faults.first : "in " + names}};
}

}  // namespace foveola
