#include "renderer/progressive/headless_render.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"

namespace foveola {
namespace {

/// Samples are traced in batches so that Ctrl-C and a time limit are answered soon, and large
/// enough for neighbouring rays to be found in them. The image does not depend on their sizes, but
/// with adaptive sampling, whose batches are of one size so that neither a machine's speed nor a
/// replay matters.
constexpr std::uint64_t smallest_batch = 1 << 14;
constexpr std::uint64_t largest_batch = 1 << 20;
constexpr double batch_target_s = 0.1;

/// A head that holds still. Its gaze goes through the head's axes and back, as a live preview's
/// does, so that both give the same picture, to the bit.
Aim aim_of(const RenderSettings& settings, const LoadedScene& loaded) {
  const AzimuthElevation& heading = loaded.camera.heading;
  const Quat head = head_orientation(heading);
  const Vec3 in_head = glm::conjugate(head) * direction_from(gaze_of(settings, loaded));
  return {.viewport = Viewport(heading, settings.field_of_view),
          .gaze = glm::normalize(head * in_head)};
}

/// A loaded scene, and a render of it that is aimed.
struct StillRender {
  Workers workers;
  LoadedScene loaded;
  std::unique_ptr<ViewSampler> sampler;
  Aim aim;
  ProgressiveRender render;

  StillRender(const SceneSource& source, const RenderSettings& settings)
      : workers(settings.threads),
        loaded(source, workers, settings.scene),
        sampler(make_view_sampler(settings.method)),
        aim(aim_of(settings, loaded)),
        render(loaded.tracer, loaded.rendered_with(settings.progressive), workers) {
    sampler->aim(aim);
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
  if (settings.progressive.adaptive) {
    batch = adaptive_pass;
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

RenderReport report_on(const LoadedScene& loaded) {
  RenderReport report;
  report.load_seconds = loaded.load_seconds;
  report.build_seconds = loaded.build_seconds;
  report.triangles = loaded.scene.triangle_count();
  report.warnings = loaded.warnings;
  report.camera = DVec3(loaded.camera.position) + loaded.scene.origin;
  report.head = loaded.camera.heading;
  return report;
}

}  // namespace

AzimuthElevation gaze_of(const RenderSettings& settings, const LoadedScene& loaded) {
  return settings.gaze.value_or(loaded.camera.heading);
}

Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop) {
  StillRender still(source, settings);
  RenderReport report = report_on(still.loaded);
  report.gaze = gaze_of(settings, still.loaded);
  report.threads = still.workers.threads();

  const SteadyClock clock;
  Progress progress("rendering");
  const Nanoseconds start = clock.now();
  double fraction = 0.0;
  while (fraction < 1.0 && !stop.stop_requested()) {
    // With adaptive sampling fewer are traced than are drawn.
    const std::uint64_t drawn = still.render.points_drawn();
    still.render.look_at(still.aim.gaze);
    const TracedSamples traced =
        still.render.advance(*still.sampler, next_batch(settings, drawn, report.seconds));
    report.samples += traced.samples;
    report.rays += traced.rays.total();
    report.seconds = seconds(clock.now() - start);
    fraction = fraction_done(settings.budget, still.render.points_drawn(), report.seconds);
    progress.update(fraction);
  }
  report.stopped = fraction < 1.0;
  report.non_finite = still.render.dropped();
  RgbImage view;
  if (settings.view) {
    view = viewport_image(still.render.film(), still.aim.viewport, settings.view->x,
                          settings.view->y, settings.unsampled, still.workers);
  }
  Rendering rendering{
      .image = still.render.film().resolve(), .view = std::move(view), .report = std::move(report)};
  if (!settings.progressive.keep_variances) {
    rendering.image.variances.clear();
  }
  return rendering;
}

ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop) {
  StillRender still(source, settings);
  const LoadedScene& loaded = still.loaded;
  const std::uint64_t points = settings.budget.samples;
  const std::uint64_t most = settings.progressive.adaptive ? adaptive_pass : largest_batch;
  std::optional<SampleJob> job;
  Progress progress("searching");
  while (!job && still.render.points_drawn() < points) {
    if (stop.stop_requested()) {
      throw Error("--replay", "stopped before the sample was found");
    }
    still.render.look_at(still.aim.gaze);
    job =
        still.render.find_job(*still.sampler, std::min(most, points - still.render.points_drawn()),
                              address.pixel, address.sample_number);
    progress.update(static_cast<double>(still.render.points_drawn()) / static_cast<double>(points));
  }
  if (!job) {
    throw Error("--replay", "this render does not take that sample of that pixel",
                "repeat the options of the render that listed it, with at least as many --samples");
  }
  ReplayedPath path{
      .job = *job,
      .record = loaded.tracer.replay(loaded.camera.position, *job, still.render.trace_settings()),
      .object_names = {}};
  for (const PathVertex& vertex : path.record.vertices) {
    path.object_names.push_back(vertex.object ? loaded.scene.object_name(*vertex.object) : "");
  }
  return path;
}

}  // namespace foveola
