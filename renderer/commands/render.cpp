#include "renderer/commands/render.h"

#include <algorithm>
#include <numbers>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/preview/preview.h"
#include "renderer/scene/load_scene.h"

namespace foveola {
namespace {

/// Samples are traced in batches so that Ctrl-C and a time limit are answered soon, and large
/// enough for neighbouring rays to be found in them. The image does not depend on their sizes.
constexpr std::uint64_t smallest_batch = 1 << 14;
constexpr std::uint64_t largest_batch = 1 << 20;
/// Where each batch decides on the next, so that neither a machine's speed nor a replay matters.
constexpr std::uint64_t spare_batch = 1 << 16;
constexpr double batch_target_s = 0.1;

/// What any renderer can show: for comparing with others.
void make_diffuse(Material& material) {
  material.metallic = 0.0F;
  material.specular = 0.0F;
  material.transmission = 0.0F;
  material.clearcoat = 0.0F;
  material.sheen_color = Rgb(0.0F);
  material.normal_texture = {};
}

Scene load(const SceneSource& source, const RenderSettings& settings) {
  Scene scene = load_scene(source);
  if (settings.diffuse) {
    std::for_each(scene.materials.begin(), scene.materials.end(), make_diffuse);
  }
  return scene;
}

CameraView choose_camera(const SceneSource& source, const Scene& scene,
                         const RenderSettings& settings) {
  CameraView view;
  if (source.camera_position) {
    view = {.name = "",
            .position = scene.from_file(*source.camera_position),
            .heading = source.heading};
  } else if (!scene.cameras.empty()) {
    view = scene.cameras.front();
  } else {
    const Bounds bounds = scene.bounds();
    view.position = 0.5F * (bounds.lower + bounds.upper);
  }
  if (settings.camera) {
    view.position = scene.from_file(*settings.camera);
  }
  view.heading = settings.head.value_or(view.heading);
  return view;
}

/// How long one of `steps` takes.
template <typename Step>
auto timed(double& elapsed_s, const Step& step) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  auto result = step();
  elapsed_s = seconds(clock.now() - start);
  return result;
}

PreviewSettings preview_settings(const RenderSettings& settings, const Vec3& viewpoint) {
  PreviewSettings preview;
  preview.film_width = settings.size.x;
  preview.film_height = settings.size.y;
  preview.horizontal_fov_deg = settings.fov_deg;
  preview.vertical_fov_deg = settings.fov_deg;
  preview.viewpoint = viewpoint;
  if (settings.spare_done_contrast > 0.0) {
    preview.spare_done = VisibleNoise{.contrast = settings.spare_done_contrast};
  }
  preview.trace.max_depth = settings.max_depth;
  preview.trace.largest_radiance = settings.largest_radiance;
  preview.trace.pixel_angle_rad =
      static_cast<float>(2.0 * std::numbers::pi / static_cast<double>(settings.size.x));
  return preview;
}

/// A scene on the stage: loaded, built, with a head and an eye that hold still.
struct Stage {
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  Workers workers;
  Scene scene;
  PathTracer tracer;
  CameraView camera;
  AzimuthElevation gaze;
  ScriptedHeadTracker head;
  FixedEyeTracker eye;
  Preview preview;

  Stage(const SceneSource& source, const RenderSettings& settings)
      : workers(settings.threads),
        scene(timed(load_seconds, [&] { return load(source, settings); })),
        tracer(timed(build_seconds, [&] { return PathTracer(scene, workers); })),
        camera(choose_camera(source, scene, settings)),
        gaze(settings.gaze.value_or(camera.heading)),
        head({{.time = Nanoseconds(0), .heading = camera.heading}}),
        eye(glm::conjugate(head_orientation(camera.heading)) * direction_from(gaze)),
        preview(tracer, preview_settings(settings, camera.position), eye, head, workers) {
    preview.restart(settings.method, settings.seed);
  }
};

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

std::uint64_t next_batch(const RenderSettings& settings, std::uint64_t samples, double elapsed_s) {
  const RenderBudget& budget = settings.budget;
  std::uint64_t batch = smallest_batch;
  if (settings.spare_done_contrast > 0.0) {
    batch = spare_batch;
  } else if (elapsed_s > 0.0) {
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
  Stage stage(source, settings);
  RenderReport report;
  report.threads = stage.workers.threads();
  report.load_seconds = stage.load_seconds;
  report.build_seconds = stage.build_seconds;
  report.triangles = stage.scene.triangle_count();
  report.warnings = stage.scene.warnings;
  report.camera = DVec3(stage.camera.position) + stage.scene.origin;
  report.head = stage.camera.heading;
  report.gaze = stage.gaze;

  const SteadyClock clock;
  Progress progress("rendering");
  const Nanoseconds start = clock.now();
  double fraction = 0.0;
  std::uint64_t sent = 0;  // more than are traced, where some are spared
  while (fraction < 1.0 && !stop.stop_requested()) {
    const std::uint64_t batch = next_batch(settings, sent, report.seconds);
    const FrameReport frame = stage.preview.render_frame(clock.now(), batch);
    sent += batch;
    report.samples += frame.samples;
    report.rays += frame.rays;
    report.seconds = seconds(clock.now() - start);
    fraction = fraction_done(settings.budget, sent, report.seconds);
    progress.update(fraction);
  }
  report.stopped = fraction < 1.0;
  report.non_finite = stage.preview.dropped();
  return {.image = stage.preview.film().resolve(), .report = std::move(report)};
}

ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop) {
  Stage stage(source, settings);
  const SteadyClock clock;
  std::optional<SampleJob> job;
  Progress progress("searching");
  for (std::uint64_t sought = 0; !job && sought < settings.budget.samples;) {
    if (stop.stop_requested()) {
      throw Error("--replay", "stopped before the sample was found");
    }
    const std::uint64_t most = settings.spare_done_contrast > 0.0 ? spare_batch : largest_batch;
    const std::uint64_t batch = std::min(most, settings.budget.samples - sought);
    job = stage.preview.find_job(clock.now(), batch, address.pixel, address.sample_number);
    sought += batch;
    progress.update(static_cast<double>(sought) / static_cast<double>(settings.budget.samples));
  }
  if (!job) {
    throw Error("--replay", "this render does not take that sample of that pixel",
                "repeat the options of the render that listed it, with at least as many --samples");
  }
  ReplayedPath path{
      .job = *job,
      .record = stage.tracer.replay(stage.camera.position, *job, stage.preview.settings().trace),
      .object_names = {}};
  for (const PathVertex& vertex : path.record.vertices) {
    path.object_names.push_back(vertex.object ? stage.scene.object_name(*vertex.object) : "");
  }
  return path;
}

}  // namespace foveola
