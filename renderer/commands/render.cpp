#include "renderer/commands/render.h"

#include <algorithm>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/commands/stage.h"
#include "renderer/preview/preview.h"

namespace foveola {
namespace {

/// Samples are traced in batches so that Ctrl-C and a time limit are answered soon, and large
/// enough for neighbouring rays to be found in them. The image does not depend on their sizes.
constexpr std::uint64_t smallest_batch = 1 << 14;
constexpr std::uint64_t largest_batch = 1 << 20;
/// Where each batch decides on the next, so that neither a machine's speed nor a replay matters.
constexpr std::uint64_t adaptive_batch = 1 << 16;
constexpr double batch_target_s = 0.1;

/// A preview of a stage, seen by a head and an eye that hold still.
struct StillPreview {
  Stage stage;
  ScriptedHeadTracker head;
  FixedEyeTracker eye;
  Preview preview;

  StillPreview(const SceneSource& source, const RenderSettings& settings)
      : stage(source, settings),
        head({{.time = Nanoseconds(0), .heading = stage.camera.heading}}),
        eye(glm::conjugate(head_orientation(stage.camera.heading)) * direction_from(stage.gaze)),
        preview(stage.tracer,
                preview_settings(settings, stage.camera.position, source.exposure_stops), eye, head,
                stage.workers) {
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
  if (settings.adaptive_contrast > 0.0) {
    batch = adaptive_batch;
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
  StillPreview still(source, settings);
  const Stage& stage = still.stage;
  RenderReport report;
  report.threads = stage.workers.threads();
  report.load_seconds = stage.load_seconds;
  report.build_seconds = stage.build_seconds;
  report.triangles = stage.scene.triangle_count();
  report.warnings = stage.warnings;
  report.camera = DVec3(stage.camera.position) + stage.scene.origin;
  report.head = stage.camera.heading;
  report.gaze = stage.gaze;

  const SteadyClock clock;
  Progress progress("rendering");
  const Nanoseconds start = clock.now();
  double fraction = 0.0;
  std::uint64_t sent = 0;  // more than are traced, with adaptive sampling
  while (fraction < 1.0 && !stop.stop_requested()) {
    const std::uint64_t batch = next_batch(settings, sent, report.seconds);
    const FrameReport frame = still.preview.render_frame(clock.now(), batch);
    sent += batch;
    report.samples += frame.samples;
    report.rays += frame.rays;
    report.seconds = seconds(clock.now() - start);
    fraction = fraction_done(settings.budget, sent, report.seconds);
    progress.update(fraction);
  }
  report.stopped = fraction < 1.0;
  report.non_finite = still.preview.dropped();
  RgbImage view;
  if (settings.view) {
    view = viewport_image(still.preview.film(), still.preview.viewport(), settings.view->x,
                          settings.view->y, settings.unsampled, stage.workers);
  }
  Rendering rendering{.image = still.preview.film().resolve(),
                      .view = std::move(view),
                      .report = std::move(report)};
  if (!settings.variance) {
    rendering.image.variances.clear();
  }
  return rendering;
}

ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop) {
  StillPreview still(source, settings);
  const Stage& stage = still.stage;
  const SteadyClock clock;
  std::optional<SampleJob> job;
  Progress progress("searching");
  for (std::uint64_t sought = 0; !job && sought < settings.budget.samples;) {
    if (stop.stop_requested()) {
      throw Error("--replay", "stopped before the sample was found");
    }
    const std::uint64_t most = settings.adaptive_contrast > 0.0 ? adaptive_batch : largest_batch;
    const std::uint64_t batch = std::min(most, settings.budget.samples - sought);
    job = still.preview.find_job(clock.now(), batch, address.pixel, address.sample_number);
    sought += batch;
    progress.update(static_cast<double>(sought) / static_cast<double>(settings.budget.samples));
  }
  if (!job) {
    throw Error("--replay", "this render does not take that sample of that pixel",
                "repeat the options of the render that listed it, with at least as many --samples");
  }
  ReplayedPath path{
      .job = *job,
      .record = stage.tracer.replay(stage.camera.position, *job, still.preview.settings().trace),
      .object_names = {}};
  for (const PathVertex& vertex : path.record.vertices) {
    path.object_names.push_back(vertex.object ? stage.scene.object_name(*vertex.object) : "");
  }
  return path;
}

}  // namespace foveola
