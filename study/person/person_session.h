// A person's session in the window: what the state machine waits for becomes pages and pictures,
// and keys become its events.
//
// It runs in one thread, frame by frame, beside the window's, the one that draws, the one that
// writes the record, and the trackers'.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/gaze/pointer_eye_tracker.h"
#include "study/person/console.h"
#include "study/person/live_attempt.h"
#include "study/person/page_watch.h"
#include "study/person/prompt_state.h"
#include "study/person/session_log.h"
#include "study/person/simulated_operator.h"
#include "study/person/viewer.h"
#include "study/stage/seeds.h"

namespace foveola::study {

struct PersonSessionSettings {
  SessionSeed seed;
  SessionState state;                        ///< to go on from
  Nanoseconds time{0};                       ///< of the session's clock, to go on from
  std::optional<GazeCorrection> correction;  ///< of the gaze, to go on with
  std::string devices;                       ///< as the record has them, of this run
  std::optional<std::string> amendment;      ///< note_of the protocol's, if it was amended
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
    HeadTracker* head;           ///< none: keys, mouse and gamepad turn the head
    /// Who takes part in a person's place, and whose `events` then are; otherwise none.
    SimulatedOperator* simulated_operator;
    SessionRecorder* recorder;
    ConsoleLines* console;
    /// Tells the experimenter a line.
    std::function<void(const std::string& line)> tell;
  };

  PersonSession(const PersonSessionSettings& settings, const Parts& parts);

  /// Until the session is over and the participant has read so, it is interrupted by the
  /// experimenter, or `stop` is requested. Returns where it then is. Rethrows what kept the record
  /// from being written.
  Phase run(const std::stop_token& stop);

  /// In the attempts that are over.
  std::uint64_t samples() const { return samples_; }
  std::uint64_t non_finite() const { return non_finite_; }

 private:
  // Events, and what they lead to once they are on the disk.
  Nanoseconds now() const { return parts_.clock->now() - zero_; }
  bool feed(const Event& event) { return log_.feed(now(), event); }
  void begin();
  void tell_of_amendment();
  void interrupt();
  void carry_out(const DurableEvent& durable);
  void carry_out(const Effect& effect);
  void enter_scene();
  /// Renders, or waits for a gaze: no trial that follows it is begun without.
  void prepare_rendering();
  void start_rendering();
  void stop_rendering();

  // Frames.
  void show_frame();
  void show_to_operator(Nanoseconds shown);
  std::optional<ShownPixels> take_pixels();
  void go_on(Nanoseconds shown);
  void go_on_validating();
  void go_on_reacting(Nanoseconds shown);
  void go_on_arming(Nanoseconds shown);
  void go_on_timing();
  SessionPicture picture();

  // The experimenter.
  void answer_console();
  void tell_of_tracker();
  void tell_of_slow_drawing();

  // The participant.
  void answer_window();
  void answer(const WindowEvent& event);
  void answer_window_itself(const WindowEvent& event);
  void follow_size(const WindowResized& size);
  void pause_or_leave();
  void hand_in();
  void act(KeyIntent intent, Nanoseconds time);
  void set_confirmation(const std::optional<Confirmation>& confirmation);
  void turn_to_next_object();
  std::size_t object_ahead_now();
  bool is_picture_shown() const;
  bool needs_gaze() const;

  SessionContext context() const {
    return {*parts_.protocol, *parts_.plan, log_.procedure(), seen_};
  }
  /// The one that the participant is in, and its scene.
  const PlannedTrial& trial() const { return trial_at(context()); }
  const SceneStage& stage() const { return *parts_.stages->at(trial().scene); }

  PersonSessionSettings settings_;
  Parts parts_;
  Nanoseconds zero_;  ///< the clock's time at which the session's is 0
  SessionLog log_;
  SessionState seen_;  ///< what is on the disk: nothing else may be seen
  PromptState prompt_;
  PageWatch page_watch_;
  Viewer viewer_;
  std::string scene_;                       ///< that the viewer is in
  std::unique_ptr<EquirectFilm> panorama_;  ///< of that scene, without noise
  std::unique_ptr<LiveAttempt> attempt_;    ///< while it goes on
  std::vector<GazeSample> arrived_;         ///< outside of attempts
  std::uint64_t samples_ = 0;
  std::uint64_t non_finite_ = 0;
  bool was_lost_ = false;  ///< the tracker
  bool has_told_of_slow_drawing_ = false;
  bool is_done_ = false;
};

}  // namespace foveola::study
