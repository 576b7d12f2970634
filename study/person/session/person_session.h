// A person's session in the window: the driver's ports by which what the session waits for becomes
// pages and pictures, and keys become its events.
//
// It runs in one thread, frame by frame, beside the window's, the one that draws, the one that
// writes the record, and the trackers'.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "study/console/console.h"
#include "study/console/live_figures.h"
#include "study/driver/clock_watch.h"
#include "study/driver/session_driver.h"
#include "study/person/devices/viewer.h"
#include "study/person/prompts/key_intent.h"
#include "study/person/prompts/page_watch.h"
#include "study/person/prompts/prompt_state.h"
#include "study/person/session/live_attempt.h"
#include "study/person/session/simulated_operator.h"
#include "study/stage/object_sight.h"
#include "study/stage/seeds.h"
#include "study/stage/stage_reload.h"

namespace foveola::study {

inline constexpr const char* no_focus_line =
    "The participant's window does not have the keyboard: keys go elsewhere. Click into "
    "the window; then the participant continues.";

struct PersonSessionSettings {
  std::string participant;  ///< the code
  const char* eye = "";     ///< whose the gaze is: eye_of()
  SessionSeed seed;
  SessionPosition position;            ///< where the session goes on
  std::vector<std::string> notes;      ///< written when the session begins or goes on
  bool is_experimenter_blind = false;  ///< the console names no methods
  /// Each page and picture that the participant comes to is written there, as a file.
  std::optional<std::filesystem::path> screens;
};

/// What is shown; all of it must outlive the session.
struct ShownStudy {
  const Protocol& protocol;
  const Plan& plan;
  const SceneStages& stages;
  const Workers& workers;
  StageReloader* reloader = nullptr;  ///< in a rehearsal: loads scenes again whose files change
};

/// What the participant sits before; all of it must outlive the session.
struct Seat {
  const Clock& clock;  ///< steady
  WindowEvents& events;
  SessionDisplay& display;
  EyeTracker& tracker;
  PointerEyeTracker* pointer = nullptr;  ///< the tracker, if the pointer is
  HeadTracker* head = nullptr;           ///< none: keys, mouse and gamepad turn the head
  bool has_focus = true;                 ///< whether keys come to the window at the beginning
  /// Who takes part in a person's place, and whose `events` then are.
  SimulatedOperator* simulated_operator = nullptr;
  /// The computer's clocks, read before each frame.
  std::function<ClockReadings()> read_clocks = study::read_clocks;
};

class PersonSession final : private ClockPort, private DisplayPort, private InputPort {
 public:
  /// console and recorder must outlive it.
  PersonSession(const PersonSessionSettings& settings, const ShownStudy& study, const Seat& seat,
                Console& console, SessionRecorder& recorder);

  /// Until the session is over and the participant has read so, it is interrupted by the
  /// experimenter, or `stop` is requested. Rethrows what kept the record from being written.
  SessionOutcome run(const std::stop_token& stop);

 private:
  // The clock.
  Nanoseconds now() const override { return seat_.clock.now() - zero_; }

  // The display.
  void follow(const DurableEvent& durable) override;
  void carry_out(const Effect& effect) override;
  std::unique_ptr<AttemptPort> begin_attempt() override;
  void begin_frame() override;
  Nanoseconds show() override;
  void end_frame(Nanoseconds shown) override;
  void enter_scene();
  void draw_panorama();
  /// In a rehearsal: shows a scene whose files have changed, and notes it in the record.
  void follow_changes();
  void show_changed(const std::string& scene, std::unique_ptr<const SceneStage> stage);
  /// No trial that follows the gaze is begun without one.
  bool needs_gaze() const;
  bool has_gaze() const { return eye_.has_gaze(seat_.clock.now()); }
  void wait_for_gaze();
  void show_to_operator(Nanoseconds shown);
  std::optional<ShownPixels> take_pixels();
  void go_on(Nanoseconds shown);
  void go_on_validating();
  void go_on_reacting(Nanoseconds shown);
  SessionPicture picture();

  // The input: what the experimenter types, and what the participant does.
  void act(SessionDriver& driver) override;
  void answer_console();
  void note_tracker();
  void answer_window();
  void answer(const WindowEvent& event);
  void answer_window_itself(const WindowEvent& event);
  void follow_size(const WindowResized& size);
  void follow_focus(bool has_focus);
  void follow_headset(HeadsetChange change);
  void pause_if_due();
  /// What it shows does not depend on the window that shows it too.
  bool is_in_headset() const { return seat_.display.is_headset(); }
  void pause_or_leave();
  void answer_confirmation(const FormInput& input);
  void hand_in();
  void act(KeyIntent intent, Nanoseconds time);
  void ask_to_confirm(Confirmed what);
  void end_confirmation();
  void turn_to_next_object();
  std::size_t object_ahead_now();
  bool is_picture_shown() const;

  // How the session stands, for the experimenter.
  void count_frame(Nanoseconds shown);
  void show_status();
  SessionStatus status() const;
  std::vector<StatusWarning> warnings() const;

  // Whether the participant looks at the trial's object.
  const OfferedObject& chosen_object() const;
  void show_object(const OfferedObject& object, const Quat& head);
  void watch_gaze(Nanoseconds shown);
  void judge_mark();
  void judge_gaze();
  void follow_up(const std::string& finding, Remedy remedy, TimedAgain reason);

  SessionContext context() const {
    return {study_.protocol, study_.plan, driver_.procedure(), driver_.seen()};
  }
  const PlannedTrial& trial() const { return driver_.trial(); }
  const SceneStage& stage() const;

  PersonSessionSettings settings_;
  ShownStudy study_;
  Seat seat_;
  Plan told_plan_;  ///< as the experimenter may know it
  Console& console_;
  SessionRecorder& recorder_;
  Nanoseconds zero_;  ///< the clock's time at which the session's is 0
  ClockWatch clock_watch_;
  PersonTracker eye_;
  PromptState prompt_;
  PageWatch page_watch_;
  Viewer viewer_;
  std::string scene_;  ///< the scene that the viewer is in
  /// By name: the scenes that have changed, as they are now.
  std::map<std::string, std::unique_ptr<const SceneStage>> changed_;
  std::unique_ptr<EquirectFilm>
      panorama_;                     ///< the scene as it looks without noise, in direct light
  LiveAttempt* attempt_ = nullptr;   ///< the driver's, while it goes on
  LookingTimes looking_times_;       ///< the attempt's, up to its last mark
  Nanoseconds watched_until_{0};     ///< when the attempt's frame before was shown
  std::vector<GazeSample> arrived_;  ///< the gaze that came for a frame outside of attempts
  bool was_lost_ = false;            ///< whether the tracker was lost at the last frame
  Nanoseconds last_key_;             ///< session clock; at first the session's beginning
  bool has_focus_;                   ///< otherwise the participant's keys go elsewhere
  bool is_pause_due_ = false;        ///< what is seen or pressed is not what should be
  std::optional<Nanoseconds> waits_for_disk_since_;  ///< session clock, while an event does
  std::optional<SlowDrawing> slow_drawing_;          ///< once it was found in an attempt
  LiveFigures figures_;
  std::string last_mark_;  ///< in words; empty before the first
  std::optional<Nanoseconds> status_shown_;
  SessionDriver driver_;
};

}  // namespace foveola::study
