// A person's session in the window: what the state machine waits for becomes pages and pictures,
// and keys become its events.
//
// It runs in one thread, frame by frame, beside the window's, the one that draws, the one that
// writes the record, and the trackers'.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/base/random.h"
#include "renderer/gaze/pointer_eye_tracker.h"
#include "renderer/gaze/steered_head_tracker.h"
#include "renderer/window/steering.h"
#include "study/person/console.h"
#include "study/person/form.h"
#include "study/stage/gaze_validation_runs.h"
#include "study/person/live_attempt.h"
#include "study/person/object_pick.h"
#include "study/person/person_keys.h"
#include "study/person/person_tracker.h"
#include "study/person/reaction_test.h"
#include "study/person/session_display.h"
#include "study/person/session_log.h"
#include "study/person/words.h"
#include "study/record/record_thread.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"

namespace foveola::study {

struct PersonSessionSettings {
  std::int64_t session = 0;  ///< its row in the record
  SessionSeed seed;
  SessionState state;                        ///< to go on from
  Nanoseconds time{0};                       ///< of the session's clock, to go on from
  std::optional<GazeCorrection> correction;  ///< of the gaze, to go on with
  std::string devices;                       ///< as the record has them, of this run
  /// Each page and picture that the participant comes to is written there, as a file.
  std::optional<std::filesystem::path> screens;
};

class PersonSession {
 public:
  /// What it works with, all of which must outlive it.
  struct Parts {
    const Protocol* protocol;
    const Plan* plan;
    const SceneStages* stages;
    const Workers* workers;
    const Clock* clock;  ///< steady
    WindowEvents* events;
    SessionDisplay* display;
    PersonTracker* eye;
    PointerEyeTracker* pointer;  ///< the eye, if the pointer is; otherwise none
    RecordThread* record;
    ConsoleLines* console;
    /// Tells the experimenter a line.
    std::function<void(const std::string& line)> tell;
  };

  PersonSession(const PersonSessionSettings& settings, const Parts& parts);

  /// Until the session is over and the participant has read so, it is interrupted by the
  /// experimenter, or `stop` is requested. Returns where it then is. Rethrows what kept the record
  /// from being written.
  Phase run(const std::stop_token& stop);

 private:
  /// What the participant is asked to confirm.
  enum class Doubt { timing_again, stopping };

  /// The participant's head, and what steers it.
  struct Viewer {
    Viewer(const AzimuthElevation& heading, PointerEyeTracker* pointer)
        : head(heading), steering(head, pointer) {}

    SteeredHeadTracker head;
    Steering steering;
  };

  // The session's clock, and its events.
  Nanoseconds now() const { return parts_.clock->now() - zero_; }
  Nanoseconds in_session(Nanoseconds time) const { return time - zero_; }
  bool feed(const Event& event) { return log_.feed(now(), event); }
  void begin();
  void interrupt();
  void carry_out(const DurableEvent& durable);
  void follow(const Event& event);

  // Effects.
  void carry_out(const AskForConsent& effect);
  void carry_out(const AskQuestionnaire& effect);
  void carry_out(const ValidateGaze& effect);
  void carry_out(const AskForPress& effect);
  void carry_out(const AskForObject& effect);
  void carry_out(const AskWhetherReady& effect);
  void carry_out(const StartRendering& effect);
  void carry_out(const AcknowledgeMark& effect);
  void carry_out(const AskForRating& effect);
  void carry_out(const StopRendering& effect);
  void carry_out(const ShowPause& effect);
  void carry_out(const EndSession& effect);

  void enter_scene();
  void begin_viewing(const AzimuthElevation& heading);
  void tell_what_comes();
  void give_notice(Notice notice) { notices_.push_back(notice_screen(notice, texts())); }

  // The experimenter.
  void answer_console();
  void answer(const ConsoleCommand& command);
  void tell_of_tracker();

  // The participant.
  void answer_window();
  void answer(const WindowEvent& event);
  void answer_window_itself(const WindowEvent& event);
  void follow_size(const WindowResized& size);
  void press(PersonKey key, Nanoseconds time);
  void press_in_doubt(PersonKey key);
  void press_while_choosing(PersonKey key);
  std::size_t object_ahead_now() const;
  void turn_to(const Vec3& direction);
  void press_while_marking(PersonKey key, Nanoseconds time);
  void press_while_looking_around(PersonKey key);
  void press_while_paused(PersonKey key);
  void begin_validation();
  void hand_in();
  void ask_to_confirm(Doubt doubt);
  void pause_or_leave();
  bool is_form_shown() const;
  bool is_picture_shown() const;

  // Frames.
  void show_frame();
  void go_on(Nanoseconds shown);
  void go_on_validating();
  void go_on_reacting(Nanoseconds shown);
  void go_on_timing();
  void go_on_looking_around();
  SessionPicture picture();
  ViewOverlays overlays(const Quat& head) const;
  std::optional<ScreenPage> page() const;
  std::optional<ScreenPage> page_of_phase() const;
  ScreenPage page_of_validation() const;
  ScreenPage page_of_reaction() const;
  ScreenPage page_of_end() const;
  TrialCount trial_count() const;
  void show_new_page();
  void keep_picture_of_new_page();

  /// The one that the participant is in.
  const PlannedTrial& trial() const;
  const SceneStage& stage() const { return *parts_.stages->at(trial().scene); }
  const Texts& texts() const { return parts_.protocol->texts; }

  PersonSessionSettings settings_;
  Parts parts_;
  Nanoseconds zero_;  ///< the clock's time at which the session's is 0
  SessionLog log_;
  SessionState seen_;  ///< what is on the disk: nothing else may be seen
  bool is_done_ = false;
  bool was_lost_ = false;  ///< the tracker

  std::deque<ScreenPage> notices_;  ///< to be read before all else
  std::optional<Doubt> doubt_;
  // Each of these is there while it is needed.
  std::optional<Form> form_;
  std::string form_of_;  ///< the questionnaire's id; empty: consent, or the ratings
  std::optional<GazeValidationRuns> validation_;
  std::optional<ReactionTest> reaction_;
  std::unique_ptr<LiveAttempt> attempt_;

  std::unique_ptr<Viewer> viewer_;
  double pixels_per_unit_ = 1.0;            ///< of the window's coordinates
  std::string scene_;                       ///< that the viewer is in
  std::unique_ptr<EquirectFilm> panorama_;  ///< of that scene, without noise
  Pcg32 waits_;                             ///< of the reaction test
  bool reaction_appears_ = false;           ///< in this frame
  bool was_false_start_ = false;
  Nanoseconds acknowledged_until_{0};  ///< session clock
  bool wants_to_rate_ = false;
  Nanoseconds look_around_until_{0};       ///< session clock
  std::vector<GazeSample> arrived_;        ///< outside of attempts
  std::optional<Nanoseconds> page_shown_;  ///< by the clock: since when the page has been seen
  int frames_of_page_ = 0;
  int screens_taken_ = 0;
};

}  // namespace foveola::study
