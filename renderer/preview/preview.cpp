#include "renderer/preview/preview.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "renderer/base/random.h"

namespace foveola {
namespace {

/// Keeps the pattern of the directions apart from the randomness of the paths.
constexpr std::uint32_t view_stream = 0x76696577U;

Viewport viewport_for(const PreviewSettings& settings, const AzimuthElevation& heading) {
  return {head_orientation(heading), radians(settings.horizontal_fov_deg),
          radians(settings.vertical_fov_deg), settings.lens};
}

}  // namespace

Preview::Preview(const PathTracer& tracer, const PreviewSettings& settings, EyeTracker& eye,
                 HeadTracker& head, const Workers& workers)
    : tracer_(&tracer),
      settings_(settings),
      eye_(&eye),
      head_(&head),
      workers_(&workers),
      film_(settings.film_width, settings.film_height,
            settings.adaptive || settings.keep_variances ? FilmStatistics::mean_and_variance
                                                         : FilmStatistics::mean),
      viewport_(viewport_for(settings, {})) {
  if (settings_.adaptive) {
    settings_.adaptive->exposure_stops = settings.exposure_stops;
  }
}

Preview::~Preview() = default;

void Preview::restart(std::string_view method, std::uint32_t seed) {
  restart(make_view_sampler(method), seed);
}

void Preview::restart(std::unique_ptr<ViewSampler> sampler, std::uint32_t seed) {
  sampler_ = std::move(sampler);
  settings_.trace.seed = seed;
  next_point_ = 0;
  next_frame_ = 0;
  dropped_.clear();
  film_.clear();
}

FrameReport Preview::render_frame(Nanoseconds now, std::uint64_t samples) {
  FrameReport report = begin_frame(now);
  trace(samples, report);
  return report;
}

void Preview::trace(std::uint64_t samples, FrameReport& report) {
  add_samples(samples, [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
    report.samples += jobs.size();
    report.rays +=
        tracer_->trace(settings_.viewpoint, jobs, radiance, settings_.trace, *workers_).total();
  });
}

std::optional<SampleJob> Preview::find_job(Nanoseconds now, std::uint64_t samples,
                                           std::uint32_t pixel, std::uint32_t sample_number) {
  std::optional<SampleJob> found;
  begin_frame(now);
  add_samples(samples, [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
    if (settings_.adaptive) {
      tracer_->trace(settings_.viewpoint, jobs, radiance, settings_.trace, *workers_);
    } else {
      std::fill(radiance.begin(), radiance.end(), Rgb(0.0F));
    }
    const auto job = std::find_if(jobs.begin(), jobs.end(), [&](const SampleJob& candidate) {
      return candidate.pixel == pixel && candidate.sample_number == sample_number;
    });
    if (job != jobs.end()) {
      found = *job;
    }
  });
  return found;
}

void Preview::add_samples(std::uint64_t samples, const SamplePass::Trace& trace) {
  const SobolRange points = {
      .first = next_point_, .count = samples, .seed = mix(settings_.trace.seed, view_stream)};
  SamplePass::Adjust adjust;
  if (settings_.adaptive) {
    adjust = [&](std::vector<ViewSample>& view_samples) {
      const auto frame = static_cast<std::uint32_t>(next_frame_);
      redirect_samples(film_, last_gaze_, *settings_.adaptive, mix(points.seed, frame),
                       view_samples, *workers_);
    };
  }
  const std::vector<DroppedSample> dropped =
      pass_.run(*sampler_, points, trace, film_, *workers_, adjust);
  dropped_.insert(dropped_.end(), dropped.begin(), dropped.end());
  next_point_ += samples;
}

FrameReport Preview::begin_frame(Nanoseconds now) {
  const AzimuthElevation heading = head_->pose(now).heading;
  poll_gaze(now);
  const GazeSample used = last_valid_gaze_.value_or(GazeSample{.time = now});
  const Vec3 gaze = held_gaze_.value_or(glm::normalize(head_orientation(heading) * used.direction));
  FrameReport report = begin_frame(now, heading, gaze);
  report.gaze_valid = newest_gaze_is_valid_;
  report.gaze_held = held_gaze_.has_value();
  report.gaze_age = now - used.time;
  return report;
}

FrameReport Preview::begin_frame(Nanoseconds now, const AzimuthElevation& head, const Vec3& gaze) {
  assert(sampler_ != nullptr);
  viewport_ = viewport_for(settings_, head);
  last_gaze_ = gaze;
  sampler_->aim({.viewport = viewport_, .gaze = gaze, .pointer = pointer_});
  return {.frame = next_frame_++, .time = now, .head = head, .gaze = gaze};
}

void Preview::set_view(const PreviewView& view) {
  viewport_ = Viewport(viewport_.head(), radians(view.horizontal_fov_deg),
                       radians(view.vertical_fov_deg), view.lens);
  settings_.horizontal_fov_deg = view.horizontal_fov_deg;
  settings_.vertical_fov_deg = view.vertical_fov_deg;
  settings_.lens = view.lens;
}

void Preview::poll_gaze(Nanoseconds now) {
  arrived_gaze_.clear();
  eye_->poll(now, arrived_gaze_);
  for (const GazeSample& sample : arrived_gaze_) {
    newest_gaze_is_valid_ = sample.valid;
    if (sample.valid) {
      last_valid_gaze_ = sample;
    }
  }
}

void Preview::hold_gaze(bool held) {
  if (!held) {
    held_gaze_.reset();
  } else if (!held_gaze_) {
    held_gaze_ = last_gaze_;
  }
}

const RgbImage& Preview::present() {
  if (!resampler_) {
    resampler_.emplace(film_, ViewImage{.width = settings_.view_width,
                                        .height = settings_.view_height,
                                        .unsampled = settings_.unsampled,
                                        .exposure_stops = settings_.exposure_stops});
  }
  return resampler_->show(viewport_, *workers_);
}

}  // namespace foveola
