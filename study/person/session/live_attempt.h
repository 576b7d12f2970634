// Runs one attempt at a trial for a person: frames at the display's rate, and their record.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "renderer/base/clock.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/preview/live_frames.h"
#include "renderer/preview/preview.h"
#include "renderer/window/drawing/slow_drawing.h"
#include "study/driver/ports.h"
#include "study/person/devices/person_tracker.h"
#include "study/person/devices/session_display.h"
#include "study/record/write/session_recorder.h"
#include "study/stage/attempt_log.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// Inputs of an attempt; everything referred to must outlive it.
struct AttemptSetting {
  const Protocol& protocol;
  const SceneStage&
      stage;  ///< must outlive the attempt, or the call of show_scene() that replaces it
  const Workers& workers;
  const Clock& clock;
  SessionDisplay& display;
  PersonTracker& eye;
  HeadTracker& head;
  SessionRecorder& recorder;
  AttemptKey key;
  PlannedTrial trial;
  std::uint32_t seed = 0;       ///< the seed of the sample points and light paths
  Nanoseconds session_zero{0};  ///< the clock's time of session time 0
  /// Called while a frame waits for its refresh, before it reads head and gaze.
  std::function<void()> while_waiting;
  /// Returns the page over the picture; empty if there is none.
  std::function<std::optional<ScreenPage>()> page;
  bool is_dark = false;  ///< the picture is drawn as usual, but black
};

class LiveAttempt final : public AttemptPort {
 public:
  /// The display shows the attempt's film during its lifetime, and keeps the drawing times that its
  /// frames measured.
  explicit LiveAttempt(AttemptSetting setting);
  ~LiveAttempt() override;
  LiveAttempt(const LiveAttempt&) = delete;
  LiveAttempt& operator=(const LiveAttempt&) = delete;

  /// Renders and presents the next frame; a catch trial presents its picture without rendering.
  Nanoseconds show(Nanoseconds until) override;
  void complete_record() override { log_.finish(preview_.film()); }
  /// Continues in another version of the scene, with an empty film. `stage` must outlive the
  /// attempt.
  void show_scene(const SceneStage& stage);
  /// Begins the questions. picture: behaviour of the picture from the next frame on.
  void begin_rating(WhileRating picture);
  void give_way(bool gives_way) { frames_.give_way(gives_way); }
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.dropped().size(); }

  /// Returns the measured drawing time if drawing is too slow for frames to be in time; else empty.
  std::optional<SlowDrawing> slow_drawing() const;
  const FrameRow& newest_frame() const { return newest_frame_; }
  const std::vector<GazeSample>& arrived_gaze() const { return preview_.arrived_gaze(); }
  /// The viewport of the last frame.
  const Viewport& viewport() const { return preview_.viewport(); }

 private:
  LiveFrame next_untraced();
  void draw(const Preview& preview);
  void wait_until(Nanoseconds time) const;
  void keep(const LiveFrame& frame);

  AttemptSetting setting_;
  ViewLook look_;
  Preview preview_;
  LiveFrames frames_;
  AttemptLog log_;
  bool is_traced_;
  Nanoseconds next_untraced_{0};
  FrameRow newest_frame_;
};

}  // namespace foveola::study
