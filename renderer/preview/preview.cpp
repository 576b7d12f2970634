#include "renderer/preview/preview.h"

#include "renderer/base/random.h"
#include "renderer/film/tone_mapping.h"
#include "renderer/film/viewport_image.h"

namespace foveola {
namespace {

/// Keeps the pattern of the directions apart from the randomness of the paths.
constexpr std::uint32_t view_stream = 0x76696577U;

/// Points are drawn in blocks of this size.
constexpr std::size_t point_block = 4096;

Viewport viewport_for(const PreviewSettings& settings, const AzimuthElevation& heading) {
  return {head_orientation(heading), radians(settings.horizontal_fov_deg),
          radians(settings.vertical_fov_deg)};
}

}  // namespace

Preview::Preview(const PathTracer& tracer, const PreviewSettings& settings, EyeTracker& eye,
                 HeadTracker& head, const Workers& workers)
    : tracer_(&tracer),
      settings_(settings),
      eye_(&eye),
      head_(&head),
      workers_(&workers),
      film_(settings.film_width, settings.film_height),
      viewport_(viewport_for(settings, {})) {}

Preview::~Preview() = default;

void Preview::restart(std::string_view method, std::uint32_t seed) {
  sampler_ = make_view_sampler(method);
  settings_.trace.seed = seed;
  next_point_ = 0;
  next_frame_ = 0;
  dropped_.clear();
  film_.clear();
}

FrameReport Preview::render_frame(Nanoseconds now, std::uint64_t samples) {
  FrameReport report = aim(now);
  report.samples = samples;
  place(samples);
  film_.number(samples_, batch_);
  radiance_.resize(batch_.jobs.size());
  const RayCounts rays =
      tracer_->trace(settings_.viewpoint, batch_.jobs, radiance_, settings_.trace, *workers_);
  report.rays = rays.total();
  const std::vector<DroppedSample> dropped = film_.add(batch_, radiance_, *workers_);
  dropped_.insert(dropped_.end(), dropped.begin(), dropped.end());
  return report;
}

FrameReport Preview::aim(Nanoseconds now) {
  const HeadPose head = head_->pose(now);
  const std::optional<GazeSample> newest = eye_->newest(now);
  const bool valid = newest && newest->valid;
  if (valid) {
    last_valid_gaze_ = *newest;
  }
  viewport_ = viewport_for(settings_, head.heading);
  const Vec3 gaze = glm::normalize(viewport_.head() * last_valid_gaze_.direction);
  sampler_->aim({.viewport = viewport_, .gaze = gaze});
  return {.frame = next_frame_++,
          .time = now,
          .head = head.heading,
          .gaze = gaze,
          .gaze_valid = valid,
          .gaze_age = now - last_valid_gaze_.time};
}

void Preview::place(std::uint64_t samples) {
  points_.resize(samples);
  samples_.resize(samples);
  const std::uint32_t pattern_seed = mix(settings_.trace.seed, view_stream);
  workers_->for_each_block(samples, point_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points_[i] = sobol_2d(next_point_ + i, pattern_seed);
    }
    sampler_->sample(std::span(points_).subspan(begin, end - begin),
                     std::span(samples_).subspan(begin, end - begin));
  });
  next_point_ += samples;
}

RgbImage Preview::present() const {
  return display_image(
      viewport_image(film_, viewport_, settings_.view_width, settings_.view_height),
      settings_.exposure_stops);
}

}  // namespace foveola
