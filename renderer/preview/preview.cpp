#include "renderer/preview/preview.h"

#include <cassert>
#include <utility>

namespace foveola {
namespace {

ProgressiveSettings render_settings(const PreviewSettings& settings) {
  ProgressiveSettings render = settings.render;
  if (render.adaptive) {
    render.adaptive->exposure_stops = settings.exposure_stops;
  }
  return render;
}

}  // namespace

Preview::Preview(const PathTracer& tracer, const PreviewSettings& settings, EyeTracker& eye,
                 HeadTracker& head, const Workers& workers)
    : settings_(settings),
      eye_(&eye),
      head_(&head),
      workers_(&workers),
      render_(tracer, render_settings(settings), workers),
      viewport_({}, settings.field_of_view),
      gaze_filter_(settings.gaze_filter) {}

Preview::~Preview() = default;

void Preview::restart(std::string_view method, std::uint32_t seed) {
  restart(make_view_sampler(method), seed);
}

void Preview::restart(std::unique_ptr<ViewSampler> sampler, std::uint32_t seed) {
  sampler_ = std::move(sampler);
  next_frame_ = 0;
  render_.restart(seed);
}

void Preview::stand_at(const Vec3& viewpoint) {
  settings_.render.viewpoint = viewpoint;
  next_frame_ = 0;
  render_.stand_at(viewpoint);
}

void Preview::show(const PathTracer& tracer, const Vec3& viewpoint) {
  render_.use(tracer);
  stand_at(viewpoint);
}

FrameReport Preview::render_frame(Nanoseconds now, std::uint64_t samples) {
  FrameReport report = begin_frame(now);
  trace(samples, report);
  return report;
}

void Preview::trace(std::uint64_t samples, FrameReport& report) {
  const TracedSamples traced = render_.advance(*sampler_, samples);
  report.samples += traced.samples;
  report.rays += traced.rays.total();
}

FrameReport Preview::begin_frame(Nanoseconds now) {
  const HeadPose head = head_->pose(now);
  poll_gaze(now);
  const GazeSample used = last_valid_gaze_.value_or(GazeSample{.time = now});
  const HeadPose head_then = newest_gaze_is_valid_ ? head_->pose_at_gaze(used.time, now) : head;
  const Vec3 gaze = held_gaze_.value_or(glm::normalize(head_then.orientation() * used.direction));
  FrameReport report = begin_frame(head, gaze);
  report.gaze_valid = newest_gaze_is_valid_;
  report.gaze_held = held_gaze_.has_value();
  report.gaze_age = now - used.time;
  return report;
}

FrameReport Preview::begin_frame(const HeadPose& head, const Vec3& gaze) {
  assert(sampler_ != nullptr);
  viewport_ = viewport_of(head.orientation(), settings_.field_of_view);
  last_gaze_ = gaze;
  render_.look_at(gaze);
  sampler_->aim({.viewport = viewport_,
                 .gaze = gaze,
                 .pointer = pointer_,
                 .seen = settings_.field_of_view.seen});
  return {.frame = next_frame_++,
          .time = head.time,
          .head = head.heading,
          .head_roll_rad = head.roll_rad,
          .gaze = gaze};
}

void Preview::set_view(const FieldOfView& view) {
  viewport_ = viewport_of(viewport_.head(), view);
  settings_.field_of_view = view;
}

void Preview::poll_gaze(Nanoseconds now) {
  arrived_gaze_.clear();
  eye_->poll(now, arrived_gaze_);
  for (const GazeSample& sample : gaze_filter_.filtered(now, arrived_gaze_)) {
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
    resampler_.emplace(film(), ViewImage{.width = settings_.view_size.x,
                                         .height = settings_.view_size.y,
                                         .unsampled = settings_.unsampled,
                                         .exposure_stops = settings_.exposure_stops});
  }
  return resampler_->show(viewport_, *workers_);
}

}  // namespace foveola
