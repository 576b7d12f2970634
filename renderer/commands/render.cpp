#include "renderer/commands/render.h"

#include <algorithm>

#include "renderer/base/clock.h"
#include "renderer/base/progress.h"
#include "renderer/preview/preview.h"
#include "renderer/scene/load_scene.h"

namespace foveola {
namespace {

/// Samples are traced in batches so that Ctrl-C and a time limit are answered soon, and large
/// enough for neighbouring rays to be found in them. The image does not depend on their sizes.
constexpr std::uint64_t smallest_batch = 1 << 14;
constexpr std::uint64_t largest_batch = 1 << 20;
constexpr double batch_target_s = 0.1;

Scene load(const SceneSource& source, const RenderSettings& settings) {
  Scene scene = load_scene(source);
  if (settings.environment_file) {
    scene.environment = load_environment(*settings.environment_file);
  }
  return scene;
}

CameraView choose_camera(const SceneSource& source, const Scene& scene,
                         const RenderSettings& settings) {
  CameraView view;
  if (source.camera_position) {
    view = {.name = "", .position = *source.camera_position, .heading = source.heading};
  } else if (!scene.cameras.empty()) {
    view = scene.cameras.front();
  } else {
    const Bounds bounds = scene.bounds();
    view.position = 0.5F * (bounds.lower + bounds.upper);
  }
  view.position = settings.camera.value_or(view.position);
  view.heading = settings.head.value_or(view.heading);
  return view;
}

double fraction_done(const RenderBudget& budget, std::uint64_t samples, double elapsed_s) {
  double fraction = 0.0;
  if (budget.samples > 0) {
    fraction = static_cast<double>(samples) / static_cast<double>(budget.samples);
  }
  if (budget.seconds > 0.0) {
    fraction = std::max(fraction, elapsed_s / budget.seconds);
  }
  return std::min(fraction, 1.0);
}

std::uint64_t next_batch(const RenderBudget& budget, std::uint64_t samples, double elapsed_s) {
  std::uint64_t batch = smallest_batch;
  if (elapsed_s > 0.0) {
    const double rate = static_cast<double>(samples) / elapsed_s;
    double aim_s = batch_target_s;
    if (budget.seconds > 0.0) {
      aim_s = std::min(aim_s, budget.seconds - elapsed_s);
    }
    batch = std::clamp(static_cast<std::uint64_t>(rate * aim_s), smallest_batch, largest_batch);
  }
  return budget.samples > 0 ? std::min(batch, budget.samples - samples) : batch;
}

}  // namespace

Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop) {
  const SteadyClock clock;
  const Workers workers(settings.threads);
  RenderReport report;
  report.threads = workers.threads();

  const Nanoseconds load_start = clock.now();
  const Scene scene = load(source, settings);
  report.load_seconds = seconds(clock.now() - load_start);
  report.triangles = scene.triangle_count();
  report.warnings = scene.warnings;

  const Nanoseconds build_start = clock.now();
  const PathTracer tracer(scene, workers);
  report.build_seconds = seconds(clock.now() - build_start);

  const CameraView camera = choose_camera(source, scene, settings);
  report.camera = camera.position;
  report.head = camera.heading;
  report.gaze = settings.gaze.value_or(camera.heading);

  ScriptedHeadTracker head({{.time = Nanoseconds(0), .heading = camera.heading}});
  const Quat world_to_head = glm::conjugate(head_orientation(camera.heading));
  FixedEyeTracker eye(world_to_head * direction_from(report.gaze));

  PreviewSettings preview_settings;
  preview_settings.film_width = settings.size.x;
  preview_settings.film_height = settings.size.y;
  preview_settings.horizontal_fov_deg = settings.fov_deg;
  preview_settings.vertical_fov_deg = settings.fov_deg;
  preview_settings.viewpoint = camera.position;
  preview_settings.trace.max_depth = settings.max_depth;
  Preview preview(tracer, preview_settings, eye, head, workers);
  preview.restart(settings.method, settings.seed);

  Progress progress("rendering");
  const Nanoseconds start = clock.now();
  double fraction = 0.0;
  while (fraction < 1.0 && !stop.stop_requested()) {
    const std::uint64_t batch = next_batch(settings.budget, report.samples, report.seconds);
    const FrameReport frame = preview.render_frame(clock.now(), batch);
    report.samples += frame.samples;
    report.rays += frame.rays;
    report.seconds = seconds(clock.now() - start);
    fraction = fraction_done(settings.budget, report.samples, report.seconds);
    progress.update(fraction);
  }
  report.stopped = fraction < 1.0;
  report.non_finite = preview.dropped();
  return {.image = preview.film().resolve(), .report = std::move(report)};
}

}  // namespace foveola
