// The procedure as a pure state machine: what a session is waiting for, and what each event does.
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
  validation,       ///< waiting for how well the tracker sees the gaze
  reaction,         ///< waiting for a key press at what appears
  choosing_object,  ///< waiting for the choice of an object of the trial's scene
  ready,            ///< waiting for the participant to start the trial
  armed,            ///< rendering was asked for; waiting for its first frame to be presented
  marking,          ///< waiting for the next mark
  rating,           ///< looking around, waiting for the rating
  paused,
  interrupted,  ///< the program stopped or died; the session can be resumed
  completed,
  withdrawn,
  excluded,
  refused,  ///< by the protocol's gate: the tracker did not see the gaze well enough
};

const char* name_of(Phase phase);

/// One look at all of a validation's targets.
struct GazeRun {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< what the gaze went through; empty: nothing
  bool passed = false;                       ///< whether it passed the protocol's gate
};

// What can happen. Times are of the session's clock.
struct SessionStarted {};
struct ConsentGiven {
  std::string text_sha256;  ///< of the text that was agreed to; empty in records that do not say it
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
/// What the gaze goes through from now on: what the last run went through, if it passed.
std::optional<GazeCorrection> correction_after(const GazeValidated& validation);

/// A press at what appeared at `shown`. One before that is a false start: kept, and asked for
/// again.
struct ReactionPressed {
  Nanoseconds shown{0};
  Nanoseconds time{0};  ///< when the key went down
};
struct ObjectChosen {
  std::string object;
};
struct TrialStarted {};
struct FirstFramePresented {
  Nanoseconds time{0};
};
/// The mark that is waited for was made.
struct Marked {
  Nanoseconds time{0};
};
/// The mark that is waited for did not come in time: it is right-censored.
struct TimedOut {
  Nanoseconds time{0};
};
struct Rated {
  std::vector<Answer> answers;  ///< one to each of the protocol's ratings
  /// From the last mark, or its time-out, until the questions came; empty if it was not measured.
  std::optional<Nanoseconds> looked_around{};
};
/// The timing failed: the whole method is timed again, with the same object.
struct RetimeRequested {};
struct PauseRequested {};
struct Interrupted {};
/// After a pause or an interruption: a trial that had begun is timed again.
struct Resumed {};
/// Written by the experimenter, at any time.
struct NoteWritten {
  std::string text;
};
struct Withdrawn {};
struct Excluded {
  std::string reason;
};
/// Takes back a withdrawal or an exclusion, as long as nothing has happened since: the session is
/// then paused.
struct EndUndone {};
/// Consent is asked for anew once the session is resumed, since its text has changed.
struct ConsentAsked {};

using Event = std::variant<SessionStarted, ConsentGiven, QuestionnaireAnswered, GazeValidated,
                           ReactionPressed, ObjectChosen, TrialStarted, FirstFramePresented, Marked,
                           TimedOut, Rated, RetimeRequested, PauseRequested, Interrupted, Resumed,
                           NoteWritten, Withdrawn, Excluded, EndUndone, ConsentAsked>;

/// The name that records use: "session_started", "consent_given", "questionnaire_answered",
/// "gaze_validated", "reaction_pressed", "object_chosen", "trial_started",
/// "first_frame_presented", "marked", "timed_out", "rated", "retime_requested", "pause_requested",
/// "interrupted", "resumed", "note_written", "withdrawn", "excluded", "end_undone",
/// "consent_asked".
const char* name_of(const Event& event);

/// When an event happened: some carry their own time.
Nanoseconds time_of(const Event& event, Nanoseconds now);

// What the controller then does, in this order, after the event is durable.
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

/// All that an event's meaning depends on. A session's state follows from its agenda and the events
/// so far, so that it is made again from the record after a crash.
struct SessionState {
  Phase phase = Phase::created;
  std::size_t step = 0;        ///< index into the agenda; its size once completed
  int validations_left = 0;    ///< how many validations this step still allows, the next included
  int presses_left = 0;        ///< how many presses this step still asks for, the next included
  int attempt = 1;             ///< attempt at the trial; counts up when it has to be done again
  int timing = 1;              ///< counts up only when an attempt was asked to be retimed
  std::size_t mark = 0;        ///< index of the mark that is waited for
  std::string object;          ///< name of the object that was chosen last
  Nanoseconds first_frame{0};  ///< when the attempt's first frame was presented
  Nanoseconds last_mark{0};    ///< time of the last mark or time-out, at first the first frame's
  /// Where a pause, an interruption or an end that is undone leads back to. An attempt that had
  /// begun ends with them: then `ready`.
  Phase resumes_at = Phase::created;
  /// Where consent leads to that is asked for anew.
  Phase after_consent = Phase::created;

  bool is_over() const {
    return phase == Phase::completed || phase == Phase::withdrawn || phase == Phase::excluded ||
           phase == Phase::refused;
  }
  friend bool operator==(const SessionState&, const SessionState&) = default;
};

/// What the machine knows of a protocol.
struct Procedure {
  Agenda agenda;
  std::size_t marks = 2;  ///< how many marks a trial has, at least one
  std::vector<Question> ratings;
};

Procedure procedure_of(const Protocol& protocol, const Plan& plan);

struct Transition {
  SessionState state;
  std::vector<Effect> effects;
};

/// The state after `event`. Empty if the event is not allowed in this state: a mark skipped, a
/// second rating, a mark earlier than what came before it, another questionnaire than was asked,
/// ratings that do not answer what was asked.
std::optional<Transition> step(const Procedure& procedure, const SessionState& state,
                               const Event& event);

/// The index in the plan of the trial that the state is in; empty if it is in none, or over.
std::optional<std::size_t> trial_of(const Procedure& procedure, const SessionState& state);

}  // namespace foveola::study
