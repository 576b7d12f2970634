// The procedure as a pure state machine: what a session is waiting for, and what each event does.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/gaze_correction.h"
#include "renderer/gaze/gaze_quality.h"
#include "study/design/plan.h"

namespace foveola::study {

enum class Phase {
  created,
  validation,       ///< waiting for how well the tracker sees the gaze
  background,       ///< waiting for the questionnaire's answers
  choosing_object,  ///< of the trial's scene
  armed,            ///< rendering was asked for; waiting for its first frame to be presented
  outline,          ///< waiting for the outline mark
  material,         ///< waiting for the material mark
  rating,           ///< looking around, waiting for the rating
  completed,
  interrupted,
  withdrawn,
  refused,  ///< by the protocol's gate: the tracker did not see the gaze well enough
};

const char* name_of(Phase phase);

struct Answer {
  std::string question;
  int value = 0;
};

/// One look at all of a validation's targets.
struct GazeRun {
  GazeQuality quality;
  std::optional<GazeCorrection> correction;  ///< that the gaze went through; none: as it came
  bool passed = false;                       ///< the protocol's gate
};

// What can happen. Times are of the session's clock.
struct SessionStarted {
  int validations = 0;  ///< how often the gaze may be validated until it passes; 0: it need not be
};
struct GazeValidated {
  std::vector<GazeRun> runs;  ///< in the order of time
  bool passed = false;
};
struct BackgroundAnswered {
  std::vector<Answer> answers;
};
struct ObjectChosen {
  std::string object;
};
struct FirstFramePresented {
  Nanoseconds time{0};
};
struct OutlineMarked {
  Nanoseconds time{0};
};
struct MaterialMarked {
  Nanoseconds time{0};
};
/// The mark that is waited for did not come in time: it is censored.
struct TimedOut {
  Nanoseconds time{0};
};
struct ArtifactsRated {
  int rating = 0;  ///< 1 none ... 5 not discernible at all
};
/// The timing failed: the whole method is timed again, with the same object.
struct RetimeRequested {};
struct Interrupted {};
struct Withdrawn {};

using Event = std::variant<SessionStarted, GazeValidated, BackgroundAnswered, ObjectChosen,
                           FirstFramePresented, OutlineMarked, MaterialMarked, TimedOut,
                           ArtifactsRated, RetimeRequested, Interrupted, Withdrawn>;

const char* name_of(const Event& event);

// What the controller then does, in this order, after the event is durable.
struct ValidateGaze {};
struct AskBackground {};
struct AskForObject {};
struct StartRendering {};
struct AcknowledgeMark {};
struct AskForRating {};
struct StopRendering {};
struct EndSession {};

using Effect = std::variant<ValidateGaze, AskBackground, AskForObject, StartRendering,
                            AcknowledgeMark, AskForRating, StopRendering, EndSession>;

struct SessionState {
  Phase phase = Phase::created;
  int validations_left = 0;  ///< of the gaze, the next one included
  std::size_t trial = 0;     ///< index into the plan
  int attempt = 1;           ///< of the trial; counts up with each retiming
  std::string object;        ///< chosen for this trial
  Nanoseconds first_frame{0};
  Nanoseconds outline{0};  ///< time of the outline mark or its time-out

  bool is_over() const {
    return phase == Phase::completed || phase == Phase::interrupted || phase == Phase::withdrawn ||
           phase == Phase::refused;
  }
  friend bool operator==(const SessionState&, const SessionState&) = default;
};

struct Transition {
  SessionState state;
  std::vector<Effect> effects;
};

/// The state after `event`. Empty if the event is not allowed in this state: a mark skipped, a
/// second rating, a rating out of 1 to 5, a mark earlier than what came before it.
std::optional<Transition> step(const Plan& plan, const SessionState& state, const Event& event);

}  // namespace foveola::study
