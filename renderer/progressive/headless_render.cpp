#include "renderer/progressive/headless_render.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/scene/scene_facts.h"
#include "renderer/view/picture_sampler.h"

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
Aim aim_of_panorama(const RenderSettings& settings, const LoadedScene& loaded) {
  const AzimuthElevation& heading = loaded.camera.heading;
  const Quat head = head_orientation(heading);
  const Vec3 in_head = glm::conjugate(head) * direction_from(gaze_of(settings, loaded));
  return {.viewport = Viewport(heading, settings.field_of_view),
          .gaze = glm::normalize(head * in_head)};
}

Aim aim_of_picture(const Picture& picture, const LoadedScene& loaded) {
  return {.viewport = viewport_of(loaded.camera, picture.field_of_view),
          .gaze = direction_from(loaded.camera.heading)};
}

/// Where there is no camera, one is chosen for the picture that is made.
SceneChoices choices_of(const RenderSettings& settings) {
  SceneChoices choices = settings.scene;
  if (settings.picture) {
    choices.framed_for = picture_of({}, *settings.picture).field_of_view;
  }
  return choices;
}

/// What the film of a render is of.
struct Shot {
  IVec2 size{0};
  FieldOfView field_of_view;
  std::optional<float> pixel_angle_rad;
  Aim aim;
  std::unique_ptr<ViewSampler> sampler;
};

Shot shot_of(const RenderSettings& settings, const LoadedScene& loaded) {
  if (settings.picture) {
    const Picture picture = picture_of(loaded.camera, *settings.picture);
    return {.size = picture.size,
            .field_of_view = picture.field_of_view,
            .pixel_angle_rad = pixel_angle_rad(picture),
            .aim = aim_of_picture(picture, loaded),
            .sampler = make_picture_sampler()};
  }
  return {.size = settings.progressive.film_size,
          .field_of_view = settings.field_of_view,
          .pixel_angle_rad = std::nullopt,
          .aim = aim_of_panorama(settings, loaded),
          .sampler = make_view_sampler(settings.method)};
}

Exposure exposure_of(const RenderSettings& settings, const LoadedScene& loaded,
                     const Viewport& viewport, const Workers& workers) {
  if (settings.exposure) {
    return chosen_exposure(*settings.exposure, loaded, viewport, settings.progressive.trace,
                           workers);
  }
  return {.stops = loaded.source.exposure_stops.value_or(0.0)};
}

/// Throws Error for adaptive sampling of a picture: it takes the film for one of the sphere.
ProgressiveSettings progressive_of(const RenderSettings& settings, const LoadedScene& loaded,
                                   const Shot& shot, const Exposure& exposure) {
  if (settings.picture && settings.progressive.adaptive) {
    throw Error("adaptive sampling", "is not possible in a picture", "make a 360-degree image");
  }
  ProgressiveSettings progressive = loaded.rendered_with(settings.progressive);
  progressive.film_size = shot.size;
  progressive.pixel_angle_rad = shot.pixel_angle_rad;
  if (progressive.adaptive) {
    progressive.adaptive->exposure_stops = exposure.stops;
  }
  return progressive;
}

/// With the samples of `budget` counted in all.
RenderBudget counted(RenderBudget budget, const IVec2& size) {
  if (budget.samples_per_pixel > 0.0) {
    const double samples = budget.samples_per_pixel * size.x * size.y;
    budget.samples = static_cast<std::uint64_t>(std::max(1.0, std::round(samples)));
  }
  return budget;
}

/// A loaded scene, and a render of it that is aimed.
struct StillRender {
  Workers workers;
  LoadedScene loaded;
  Shot shot;
  Exposure exposure;
  RenderBudget budget;
  ProgressiveRender render;

  StillRender(const SceneSource& source, const RenderSettings& settings)
      : workers(settings.threads),
        loaded(source, workers, choices_of(settings)),
        shot(shot_of(settings, loaded)),
        exposure(exposure_of(settings, loaded, shot.aim.viewport, workers)),
        budget(counted(settings.budget, shot.size)),
        render(loaded.tracer, progressive_of(settings, loaded, shot, exposure), workers) {
    shot.sampler->aim(shot.aim);
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

std::uint64_t next_batch(const RenderBudget& budget, bool is_adaptive, std::uint64_t samples,
                         double elapsed_s) {
  std::uint64_t batch = smallest_batch;
  if (is_adaptive) {
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

RenderReport report_on(const StillRender& still, const RenderSettings& settings) {
  const LoadedScene& loaded = still.loaded;
  RenderReport report;
  report.load_seconds = loaded.load_seconds;
  report.build_seconds = loaded.build_seconds;
  report.triangles = loaded.scene.triangle_count();
  report.warnings = loaded.warnings;
  report.camera = DVec3(loaded.camera.position) + loaded.scene.origin;
  report.head = loaded.camera.heading;
  report.roll_rad = settings.picture ? loaded.camera.roll_rad : 0.0;
  report.gaze = settings.picture ? loaded.camera.heading : gaze_of(settings, loaded);
  report.is_lit = has_light(loaded.scene);
  report.is_enclosed = loaded.camera_is_enclosed;
  report.size = still.shot.size;
  report.field_of_view = still.shot.field_of_view;
  report.exposure = still.exposure;
  report.threads = still.workers.threads();
  return report;
}

}  // namespace

AzimuthElevation gaze_of(const RenderSettings& settings, const LoadedScene& loaded) {
  return settings.gaze.value_or(loaded.camera.heading);
}

Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop) {
  StillRender still(source, settings);
  RenderReport report = report_on(still, settings);
  const double pixels = static_cast<double>(report.size.x) * report.size.y;
  const bool is_adaptive = settings.progressive.adaptive.has_value();

  const SteadyClock clock;
  Progress progress("rendering");
  const Nanoseconds start = clock.now();
  double fraction = 0.0;
  while (fraction < 1.0 && !stop.stop_requested()) {
    // With adaptive sampling fewer are traced than are drawn.
    const std::uint64_t drawn = still.render.points_drawn();
    still.render.look_at(still.shot.aim.gaze);
    const TracedSamples traced = still.render.advance(
        *still.shot.sampler, next_batch(still.budget, is_adaptive, drawn, report.seconds));
    report.samples += traced.samples;
    report.rays += traced.rays.total();
    report.seconds = seconds(clock.now() - start);
    fraction = fraction_done(still.budget, still.render.points_drawn(), report.seconds);
    progress.update(fraction, fmt::format("{:.3g} samples per pixel",
                                          static_cast<double>(report.samples) / pixels));
  }
  report.stopped = fraction < 1.0;
  report.non_finite = still.render.dropped();
  RgbImage view;
  if (settings.view) {
    view = viewport_image(still.render.film(), still.shot.aim.viewport, settings.view->x,
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
  const IVec2& size = still.shot.size;
  if (address.pixel.x >= size.x || address.pixel.y >= size.y) {
    throw UsageError("--replay",
                     fmt::format("the image of {}x{} pixels has no pixel {},{}", size.x, size.y,
                                 address.pixel.x, address.pixel.y),
                     "give x,y,sample as render lists them");
  }
  const auto pixel =
      static_cast<std::uint32_t>(address.pixel.y) * static_cast<std::uint32_t>(size.x) +
      static_cast<std::uint32_t>(address.pixel.x);
  const std::uint64_t points = still.budget.samples;
  const std::uint64_t most = settings.progressive.adaptive ? adaptive_pass : largest_batch;
  std::optional<SampleJob> job;
  Progress progress("searching");
  while (!job && still.render.points_drawn() < points) {
    if (stop.stop_requested()) {
      throw Error("--replay", "stopped before the sample was found");
    }
    still.render.look_at(still.shot.aim.gaze);
    job = still.render.find_job(*still.shot.sampler,
                                std::min(most, points - still.render.points_drawn()), pixel,
                                address.sample_number);
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
