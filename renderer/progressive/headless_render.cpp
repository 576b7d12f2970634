#include "renderer/progressive/headless_render.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/film/film_file.h"
#include "renderer/scene/scene_facts.h"
#include "renderer/view/image_samplers.h"

namespace foveola {
namespace {

/// Batches are small enough for Ctrl-C and time limits, and large enough for coherent rays. The
/// image does not depend on their sizes, except with adaptive sampling, whose batches have one
/// size, independent of the machine's speed and of replays.
constexpr std::uint64_t smallest_batch = 1 << 14;
constexpr std::uint64_t largest_batch = 1 << 20;
constexpr double batch_target_s = 0.1;

/// A head at rest. Its gaze is transformed to the head's axes and back, as in a live preview, so
/// that both give the same picture, to the bit.
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

/// Without a camera, one is chosen for this render's picture.
SceneChoices choices_of(const RenderSettings& settings) {
  SceneChoices choices = settings.scene;
  if (settings.picture) {
    choices.framed_for = picture_of({}, *settings.picture).field_of_view;
  }
  return choices;
}

/// The view of a render's film.
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

/// Number of samples of a part by seeds.
std::uint64_t samples_in_part(const Shard& shard, std::uint64_t samples) {
  const std::int64_t part = part_of(shard, static_cast<std::int64_t>(samples)).size();
  if (part == 0) {
    throw Error("a part", "has no samples, since there are more parts than samples",
                "split it into fewer");
  }
  return static_cast<std::uint64_t>(part);
}

/// The budget with its number of samples, in all or in the part.
RenderBudget counted(const RenderSettings& settings, const IVec2& size) {
  RenderBudget budget = settings.budget;
  if (budget.samples_per_pixel > 0.0) {
    const double samples = budget.samples_per_pixel * size.x * size.y;
    budget.samples = static_cast<std::uint64_t>(std::max(1.0, std::round(samples)));
  }
  if (settings.part && settings.part->by == RenderPart::By::seeds) {
    budget.samples = samples_in_part(settings.part->shard, budget.samples);
  }
  return budget;
}

/// Separates the random numbers of parts.
constexpr std::uint32_t part_stream = 0x70617274U;

std::uint32_t seed_of(const RenderSettings& settings) {
  const std::uint32_t seed = settings.progressive.trace.seed;
  return settings.part && settings.part->by == RenderPart::By::seeds
             ? mix(mix(seed, part_stream), static_cast<std::uint32_t>(settings.part->shard.number))
             : seed;
}

/// Throws Error for settings that cannot be split into parts.
void require_splittable(const RenderSettings& settings) {
  if ((settings.part || settings.so_far != nullptr) && settings.progressive.adaptive) {
    throw Error("adaptive sampling", "needs the whole film, which is not in one place",
                "render it in one piece, or without it");
  }
  if (settings.part && settings.budget.seconds > 0.0) {
    throw Error("a time", "is not the same on two machines", "give a part a number of samples");
  }
}

/// Keeps the samples in the tiles of a part. film: must outlive it.
ProgressiveRender::Filter tiles_of(const Shard& shard, const EquirectFilm& film) {
  return [shard, &film](std::vector<ViewSample>& samples) {
    std::erase_if(samples, [&](const ViewSample& sample) {
      return shard_of_pixel(film.pixel_at(sample.image), shard.count) != shard.number;
    });
  };
}

Exposure exposure_of(const RenderSettings& settings, const LoadedScene& loaded,
                     const Viewport& viewport, const Workers& workers) {
  if (settings.exposure) {
    return chosen_exposure(*settings.exposure, loaded, viewport, settings.progressive.trace,
                           workers);
  }
  return {.stops = loaded.source.exposure_stops.value_or(0.0)};
}

/// Throws Error for adaptive sampling of a picture, since that requires a film of the sphere.
ProgressiveSettings progressive_of(const RenderSettings& settings, const LoadedScene& loaded,
                                   const Shot& shot, const Exposure& exposure) {
  if (settings.picture && settings.progressive.adaptive) {
    throw Error("adaptive sampling", "is not possible in a picture", "make a 360-degree image");
  }
  ProgressiveSettings progressive = loaded.rendered_with(settings.progressive);
  progressive.film_size = shot.size;
  progressive.pixel_angle_rad = shot.pixel_angle_rad;
  progressive.visits_pixels_in_rounds = true;
  progressive.trace.seed = seed_of(settings);
  if (progressive.adaptive) {
    progressive.adaptive->exposure_stops = exposure.stops;
  }
  return progressive;
}

/// A scene loaded for one render.
struct SceneOfRender {
  Workers workers;
  LoadedScene loaded;

  SceneOfRender(const SceneSource& source, const RenderSettings& settings,
                const std::stop_token& stop)
      : workers(settings.threads), loaded(load_watched(stop, [&] {
          return LoadedScene(source, workers, choices_of(settings));
        })) {}
};

/// An aimed render. Scene and workers must outlive it.
struct StillRender {
  const LoadedScene& loaded;
  const Workers& workers;
  Shot shot;
  Exposure exposure;
  RenderBudget budget;
  ProgressiveRender render;

  StillRender(const LoadedScene& scene, const RenderSettings& settings, const Workers& threads)
      : loaded(scene),
        workers(threads),
        shot(shot_of(settings, loaded)),
        exposure(exposure_of(settings, loaded, shot.aim.viewport, workers)),
        budget(counted(settings, shot.size)),
        render(loaded.tracer, progressive_of(settings, loaded, shot, exposure), workers) {
    shot.sampler->aim(shot.aim);
    if (settings.part && settings.part->by == RenderPart::By::tiles) {
      render.filter_samples(tiles_of(settings.part->shard, render.film()));
    }
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
  report.scene_sha256 = loaded.scene.sha256;
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
  if (settings.so_far != nullptr) {
    report.samples = settings.so_far->samples;
    report.rays = settings.so_far->rays;
    report.seconds = settings.so_far->seconds;
  }
  return report;
}

/// Throws Error for the state of a film of another kind.
void go_on_from(const RenderProgress& so_far, ProgressiveRender& render) {
  const EquirectFilm& film = render.film();
  if (so_far.film_size != IVec2(film.width(), film.height()) ||
      so_far.statistics != film.statistics()) {
    throw Error("the stored film", "has another size or other statistics",
                "give the options that it was begun with");
  }
  render.go_on_from(so_far.pixels, so_far.points_drawn, so_far.non_finite);
}

RenderProgress progress_of(const StillRender& still, const RenderReport& report) {
  return {.points_drawn = still.render.points_drawn(),
          .points = still.budget.samples,
          .samples = report.samples,
          .rays = report.rays,
          .seconds = report.seconds,
          .non_finite = still.render.dropped(),
          .film_size = still.shot.size,
          .statistics = still.render.film().statistics(),
          .pixels = state_of(still.render.film())};
}

/// progress: its display; null: none.
Rendering rendering_of(const LoadedScene& loaded, const RenderSettings& settings,
                       const Workers& workers, const std::stop_token& stop, Progress* progress) {
  require_splittable(settings);
  StillRender still(loaded, settings, workers);
  RenderReport report = report_on(still, settings);
  if (settings.begin) {
    settings.begin(report);
  }
  if (settings.so_far != nullptr) {
    go_on_from(*settings.so_far, still.render);
  }
  const double pixels = static_cast<double>(report.size.x) * report.size.y;
  const bool is_adaptive = settings.progressive.adaptive.has_value();

  const SteadyClock clock;
  const double seconds_before = report.seconds;
  const Nanoseconds start = clock.now();
  Nanoseconds saved = start;
  double fraction = fraction_done(still.budget, still.render.points_drawn(), report.seconds);
  while (fraction < 1.0 && !stop.stop_requested()) {
    // Adaptive sampling traces fewer than are drawn.
    const std::uint64_t drawn = still.render.points_drawn();
    still.render.look_at(still.shot.aim.gaze);
    const TracedSamples traced = still.render.advance(
        *still.shot.sampler, next_batch(still.budget, is_adaptive, drawn, report.seconds));
    report.samples += traced.samples;
    report.rays += traced.rays.total();
    report.trace_seconds += traced.trace_seconds;
    const double elapsed_s = seconds(clock.now() - start);
    report.draw_seconds = elapsed_s - report.trace_seconds;
    report.seconds = seconds_before + elapsed_s;
    fraction = fraction_done(still.budget, still.render.points_drawn(), report.seconds);
    if (progress != nullptr) {
      progress->update(fraction, fmt::format("{:.3g} samples per pixel",
                                             static_cast<double>(report.samples) / pixels));
    }
    if (settings.save && clock.now() - saved > settings.save_interval && fraction < 1.0) {
      settings.save(report, progress_of(still, report));
      saved = clock.now();
    }
  }
  report.stopped = fraction < 1.0;
  report.non_finite = still.render.dropped();
  if (settings.save) {
    settings.save(report, progress_of(still, report));
  }
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

}  // namespace

AzimuthElevation gaze_of(const RenderSettings& settings, const LoadedScene& loaded) {
  return settings.gaze.value_or(loaded.camera.heading);
}

Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop) {
  require_splittable(settings);
  const SceneOfRender scene(source, settings, stop);
  Progress progress("rendering");
  return rendering_of(scene.loaded, settings, scene.workers, stop, &progress);
}

Rendering render(const LoadedScene& loaded, const RenderSettings& settings, const Workers& workers,
                 std::stop_token stop) {
  return rendering_of(loaded, settings, workers, stop, nullptr);
}

ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop) {
  const SceneOfRender scene(source, settings, stop);
  const LoadedScene& loaded = scene.loaded;
  StillRender still(loaded, settings, scene.workers);
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
