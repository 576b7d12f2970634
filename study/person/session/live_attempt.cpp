#include "study/person/session/live_attempt.h"

#include <thread>
#include <utility>

#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// Below the threshold of vision for any radiance.
constexpr double darkness_stops = -60.0;

PreviewSettings preview_settings(const AttemptSetting& setting, const SceneStage& stage) {
  const PlannedTrial& trial = setting.trial;
  return trial_preview_settings(setting.protocol,
                                settings_of(setting.protocol, trial.scene, trial.method), stage);
}

ViewLook look_of(const PreviewSettings& settings) {
  return {.exposure_stops = settings.exposure_stops,
          .fill_unsampled = settings.unsampled == UnsampledPixels::filled};
}

}  // namespace

LiveAttempt::LiveAttempt(AttemptSetting setting)
    : setting_(std::move(setting)),
      look_(look_of(preview_settings(setting_, setting_.stage))),
      preview_(setting_.stage.tracer(), preview_settings(setting_, setting_.stage), setting_.eye,
               setting_.head, setting_.workers),
      frames_(
          preview_, setting_.clock, setting_.display.refresh(),
          [this](Nanoseconds time) { wait_until(time); },
          {.resample = [this](const Preview& preview) { draw(preview); },
           .present = [this] { return setting_.display.wait_until_shown(); }},
          setting_.display.frame_budget()),
      log_(setting_.recorder, setting_.key),
      is_traced_(is_rendered(setting_.trial)) {
  preview_.set_view(setting_.display.geometry().field_of_view());
  preview_.restart(make_sampler(setting_.protocol, setting_.trial.method), setting_.seed);
  if (setting_.is_dark) {
    look_.exposure_stops = darkness_stops;
  }
  setting_.display.show_film(preview_.film(), setting_.workers);
}

LiveAttempt::~LiveAttempt() {
  setting_.display.set_frame_budget(frames_.budget().for_another_preview());
  setting_.display.show_no_film();
}

Nanoseconds LiveAttempt::show(Nanoseconds /*until*/) {
  const LiveFrame frame = is_traced_ ? frames_.next() : next_untraced();
  keep(frame);
  setting_.display.set_refresh(frames_.refresh());
  return frame.shown - setting_.session_zero;
}

void LiveAttempt::begin_rating(WhileRating picture) {
  is_traced_ = is_traced_ && picture == WhileRating::converges;
  if (picture == WhileRating::blank) {
    look_.exposure_stops = darkness_stops;
  }
}

void LiveAttempt::show_scene(const SceneStage& stage) {
  look_ = look_of(preview_settings(setting_, stage));
  preview_.show(stage.tracer(), stage.viewpoint());
}

std::optional<SlowDrawing> LiveAttempt::slow_drawing() const {
  const std::optional<Nanoseconds> drawing = frames_.too_slow_drawing();
  if (!drawing) {
    return std::nullopt;
  }
  return SlowDrawing{.drawing = *drawing,
                     .interval = frames_.refresh().interval(),
                     .framebuffer = setting_.display.framebuffer(),
                     .graphics = setting_.display.graphics()};
}

LiveFrame LiveAttempt::next_untraced() {
  wait_until(next_untraced_);
  LiveFrame frame{.start = setting_.clock.now()};
  frame.report = preview_.begin_frame(frame.start);
  draw(preview_);
  frame.shown = setting_.display.wait_until_shown().value_or(setting_.clock.now());
  next_untraced_ = frame.start + frames_.refresh().interval();
  return frame;
}

void LiveAttempt::draw(const Preview& preview) {
  setting_.display.draw({.head = preview.viewport().head(),
                         .look = look_,
                         .screen = setting_.page(),
                         .lights_patch = !setting_.is_dark});
}

void LiveAttempt::wait_until(Nanoseconds time) const {
  std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
  setting_.while_waiting();
}

void LiveAttempt::keep(const LiveFrame& frame) {
  FrameRow row = frame_row(frame.report);
  row.time = frame.report.time - setting_.session_zero;
  row.presented = frame.shown - setting_.session_zero;
  row.is_late = frame.is_late();
  std::vector<GazeSample> arrived = preview_.arrived_gaze();
  for (GazeSample& sample : arrived) {
    sample.time -= setting_.session_zero;
  }
  log_.add(row, arrived);
  newest_frame_ = row;
}

}  // namespace foveola::study
