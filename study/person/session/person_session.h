// Runs a person's session in the window. Implements the driver's ports: effects become pages and
// pictures, key presses become session events.
//
// It runs in one thread, frame by frame. The window, the drawing, the record's writer and the
// trackers have threads of their own.
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
  std::string participant;  ///< the participant's code
  const char* eye = "";     ///< source of the gaze, as eye_of() names it
  SessionSeed seed;
  SessionPosition position;            ///< where the session begins or resumes
  std::vector<std::string> notes;      ///< written when the session begins or resumes
  bool is_experimenter_blind = false;  ///< the console names no methods
  /// Folder into which a picture of each page is written, if any.
  std::optional<std::filesystem::path> screens;
};

/// The study to run; everything referred to must outlive the session.
struct ShownStudy {
  const Protocol& protocol;
  const Plan& plan;
  const SceneStages& stages;
  const Workers& workers;
  StageReloader* reloader = nullptr;  ///< in a rehearsal: reloads scenes whose files have changed
};

/// The participant's equipment; everything referred to must outlive the session.
struct Seat {
  const Clock& clock;  ///< steady
  WindowEvents& events;
  SessionDisplay& display;
  EyeTracker& tracker;
  PointerEyeTracker* pointer = nullptr;  ///< the tracker, if the pointer is the eye
  HeadTracker* head = nullptr;           ///< null: keys, mouse and gamepad turn the head
  bool has_focus = true;                 ///< whether the window has the keyboard's focus at first
  /// The simulated participant, if one takes part; `events` is then its own.
  SimulatedOperator* simulated_operator = nullptr;
  /// The computer's clocks, read before each frame.
  std::function<ClockReadings()> read_clocks = study::read_clocks;
};

class PersonSession final : private ClockPort, private DisplayPort, private InputPort {
 public:
  /// console and recorder must outlive it.
  PersonSession(const PersonSessionSettings& settings, const ShownStudy& study, const Seat& seat,
                Console& console, SessionRecorder& recorder);

  /// Runs until the session is over and the participant has read so, the experimenter interrupts
  /// it, or `stop` is requested. Rethrows the error that kept the record from being written.
  SessionOutcome run(const std::stop_token& stop);

 private:
  // SessionClock
  Nanoseconds now() const override { return seat_.clock.now() - zero_; }

  // Display
  void follow(const DurableEvent& durable) override;
  void carry_out(const Effect& effect) override;
  std::unique_ptr<AttemptPort> begin_attempt() override;
  void begin_frame() override;
  Nanoseconds show() override;
  void end_frame(Nanoseconds shown) override;
  void enter_scene();
  void draw_panorama();
  /// Rehearsals: shows a scene whose files have changed, and notes it in the record.
  void follow_changes();
  void replace_scene_stage(const std::string& scene, std::unique_ptr<const SceneStage> stage);
  /// Returns whether the trial follows the gaze, and there is none: such a trial does not begin.
  bool needs_gaze() const;
  bool has_gaze() const { return eye_.has_gaze(seat_.clock.now()); }
  void wait_for_gaze();
  void show_to_operator(Nanoseconds shown);
  std::optional<ShownPixels> take_pixels();
  void continue_after_frame(Nanoseconds shown);
  void go_on_validating();
  void go_on_reacting(Nanoseconds shown);
  SessionPicture picture();

  // Input: the experimenter's commands, and the participant's keys.
  void pass_input(SessionDriver& driver) override;
  void answer_console();
  void note_tracker();
  void answer_window();
  void answer(const WindowEvent& event);
  void answer_window_itself(const WindowEvent& event);
  void follow_size(const WindowResized& size);
  void follow_focus(bool has_focus);
  void follow_headset(HeadsetChange change);
  void pause_if_due();
  /// Whether the headset's pages are independent of the window that mirrors it.
  bool is_in_headset() const { return seat_.display.is_headset(); }
  void pause_or_leave();
  void answer_confirmation(const FormInput& input);
  void hand_in();
  void carry_out_intent(KeyIntent intent, Nanoseconds time);
  void ask_to_confirm(Confirmed what);
  void end_confirmation();
  void turn_to_next_object();
  std::size_t object_ahead_now();
  bool is_picture_shown() const;

  // Status for the experimenter.
  void count_frame(Nanoseconds shown);
  void show_status();
  SessionStatus status() const;
  std::vector<StatusWarning> warnings() const;

  // Checks that the participant looks at the trial's object.
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
  Plan told_plan_;  ///< the plan as the experimenter may see it
  Console& console_;
  SessionRecorder& recorder_;
  Nanoseconds zero_;  ///< the clock's time of session time 0
  ClockWatch clock_watch_;
  PersonTracker eye_;
  PromptState prompt_;
  PageWatch page_watch_;
  Viewer viewer_;
  std::string scene_;  ///< the scene that the viewer is in
  /// Scenes that have been reloaded, by name.
  std::map<std::string, std::unique_ptr<const SceneStage>> changed_;
  std::unique_ptr<EquirectFilm> panorama_;  ///< noise-free view of the scene, in direct light
  LiveAttempt* attempt_ = nullptr;          ///< the driver's, while it lasts
  LookingTimes looking_times_;              ///< the attempt's, up to its last mark
  Nanoseconds watched_until_{0};     ///< time at which the attempt's previous frame was shown
  std::vector<GazeSample> arrived_;  ///< gaze samples of frames outside of attempts
  bool was_lost_ = false;            ///< whether the tracker was lost at the previous frame
  Nanoseconds last_key_;             ///< session clock; at first the session's beginning
  bool has_focus_;                   ///< false: the participant's keys go to another window
  bool is_pause_due_ = false;        ///< the next effect is preceded by a pause
  std::optional<Nanoseconds>
      waits_for_disk_since_;                 ///< session clock; set while an event is being written
  std::optional<SlowDrawing> slow_drawing_;  ///< set once an attempt has found it
  LiveFigures figures_;
  std::string last_mark_;  ///< in words; empty before the first mark
  std::optional<Nanoseconds> status_shown_;
  SessionDriver driver_;
};

}  // namespace foveola::study
