// The procedure as a pure state machine: the phases of a session, and the effects of each event.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "renderer/gaze/gaze_quality.h"
#include "study/design/plan.h"

namespace foveola::study {

enum class Phase {
  created,
  consent,          ///< waiting for the participant's consent
  questionnaire,    ///< waiting for a form's answers
  validation,       ///< waiting for the gaze's validation
  reaction,         ///< waiting for a key press at a stimulus
  choosing_object,  ///< waiting for the choice of an object of the trial's scene
  ready,            ///< waiting for the participant to start the trial
  armed,            ///< rendering was requested; waiting for its first frame
  marking,          ///< waiting for the next mark
  rating,           ///< looking around, waiting for the rating
  paused,
  interrupted,  ///< the program stopped or died; the session can be resumed
  completed,
  withdrawn,
  excluded,
  refused,  ///< by the protocol's gate: the gaze was not tracked well enough
};

const char* name_of(Phase phase);

/// One look at all of a validation's targets.
struct GazeRun {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< the gaze's correction during the run; empty: none
  bool passed = false;                       ///< whether it passed the protocol's gate
};

// Events. Times are of the session's clock.
struct SessionStarted {};
struct ConsentGiven {
  std::string text_sha256;  ///< of the text that was agreed to; empty in records without it
  std::string language;     ///< BCP 47 tag of the text
};
/// Consent to the protocol's text.
ConsentGiven consent_to(const Protocol& protocol);
struct QuestionnaireAnswered {
  std::string questionnaire;
  std::vector<Answer> answers;
};
struct GazeValidated {
  std::vector<GazeRun> runs;  ///< in the order of time
  bool passed = false;
};
/// Returns the gaze's correction after a validation: that of its last run, if it passed.
std::optional<GazeCorrection> correction_after(const GazeValidated& validation);

/// A press at the stimulus shown at `shown`. An earlier press is a false start: recorded, and asked
/// for again.
struct ReactionPressed {
  Nanoseconds shown{0};
  Nanoseconds time{0};  ///< time of the key press
};
struct ObjectChosen {
  std::string object;
};
struct TrialStarted {};
struct FirstFramePresented {
  Nanoseconds time{0};
};
/// The awaited mark was made.
struct Marked {
  Nanoseconds time{0};
};
/// The awaited mark was not made in time: it is right-censored.
struct TimedOut {
  Nanoseconds time{0};
};
struct Rated {
  std::vector<Answer> answers;  ///< one per rating of the protocol
  /// From the last mark, or its time-out, until the questions; empty if it was not measured.
  std::optional<Nanoseconds> looked_around{};
};
/// The timing failed: the whole method is retimed, with the same object.
struct RetimeRequested {};
struct PauseRequested {};
struct Interrupted {};
/// Continues after a pause or an interruption: a trial that had begun is retimed.
struct Resumed {};
/// Written by the experimenter, at any time.
struct NoteWritten {
  std::string text;
};
struct Withdrawn {};
struct Excluded {
  std::string reason;
};
/// Undoes a withdrawal or an exclusion that is the last event: the session is then paused.
struct EndUndone {};
/// Asks for consent anew in a resumed session, because its text has changed.
struct ConsentAsked {};

using Event = std::variant<SessionStarted, ConsentGiven, QuestionnaireAnswered, GazeValidated,
                           ReactionPressed, ObjectChosen, TrialStarted, FirstFramePresented, Marked,
                           TimedOut, Rated, RetimeRequested, PauseRequested, Interrupted, Resumed,
                           NoteWritten, Withdrawn, Excluded, EndUndone, ConsentAsked>;

/// Returns the name in records: "session_started", "consent_given", "questionnaire_answered",
/// "gaze_validated", "reaction_pressed", "object_chosen", "trial_started", "first_frame_presented",
/// "marked", "timed_out", "rated", "retime_requested", "pause_requested", "interrupted", "resumed",
/// "note_written", "withdrawn", "excluded", "end_undone", "consent_asked".
const char* name_of(const Event& event);

/// Returns the time of an event: its own if it carries one, else `now`.
Nanoseconds time_of(const Event& event, Nanoseconds now);

// Effects: the controller's next actions, in this order, after the event has been committed to
// disk.
struct AskForConsent {};
struct AskQuestionnaire {
  std::string questionnaire;
};
struct ValidateGaze {};
struct AskForPress {};
struct AskForObject {};
struct AskWhetherReady {};
struct StartRendering {};
struct AcknowledgeMark {};
struct AskForRating {};
struct StopRendering {};
struct ShowPause {};
struct EndSession {};

using Effect = std::variant<AskForConsent, AskQuestionnaire, ValidateGaze, AskForPress,
                            AskForObject, AskWhetherReady, StartRendering, AcknowledgeMark,
                            AskForRating, StopRendering, ShowPause, EndSession>;

/// Everything that the meaning of an event depends on. It follows from a session's agenda and its
/// events so far, so that it can be restored from the record after a crash.
struct SessionState {
  Phase phase = Phase::created;
  std::size_t step = 0;      ///< index into the agenda; its size once completed
  int validations_left = 0;  ///< remaining validations of this step, including the next
  int presses_left = 0;      ///< remaining presses of this step, including the next
  int attempt = 1;           ///< number of the attempt at the trial
  /// Number of this timing, from 1: a requested retiming raises it, an interruption does not.
  int timing = 1;
  std::size_t mark = 0;        ///< index of the awaited mark
  std::string object;          ///< name of the last chosen object
  Nanoseconds first_frame{0};  ///< time of the attempt's first frame
  Nanoseconds last_mark{0};    ///< time of the last mark or time-out, at first of the first frame
  /// Phase after a pause, an interruption or an undone end. These end an attempt that had begun:
  /// then `ready`.
  Phase resumes_at = Phase::created;
  /// Phase after consent that is asked for anew.
  Phase after_consent = Phase::created;

  bool is_over() const {
    return phase == Phase::completed || phase == Phase::withdrawn || phase == Phase::excluded ||
           phase == Phase::refused;
  }
  friend bool operator==(const SessionState&, const SessionState&) = default;
};

/// The protocol, as far as the state machine needs it.
struct Procedure {
  Agenda agenda;
  std::size_t marks = 2;  ///< number of marks per trial, at least one
  std::vector<Question> ratings;
};

/// Returns the procedure of one participant, whose plan has the orders.
Procedure procedure_of(const Protocol& protocol, const Plan& plan);

struct Transition {
  SessionState state;
  std::vector<Effect> effects;
};

/// Returns the state after `event`. Empty if the event is not allowed in this state: a skipped
/// mark, a second rating, a mark earlier than the previous event, answers to a
/// questionnaire that was not asked, ratings that do not match the questions.
std::optional<Transition> step(const Procedure& procedure, const SessionState& state,
                               const Event& event);

/// Returns the index in the plan of the state's trial; empty if it is in none, or over.
std::optional<std::size_t> trial_of(const Procedure& procedure, const SessionState& state);

}  // namespace foveola::study
