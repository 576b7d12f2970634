// State of the participant's screen: the current question, and the notices before it.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "renderer/window/drawing/view_geometry.h"
#include "study/person/forms/confirmation.h"
#include "study/person/forms/form.h"
#include "study/person/prompts/reaction_presses.h"
#include "study/person/prompts/session_context.h"
#include "study/stage/gaze_validation_runs.h"

namespace foveola::study {

/// Each member is set while it is needed. Times are of the session's clock.
struct PromptState {
  std::optional<Confirmation> confirmation;  ///< takes precedence over everything else
  std::deque<ScreenPage> notices;            ///< read before anything is asked
  std::optional<Form> form;
  std::string form_of;  ///< the questionnaire's id; empty: consent, or the ratings
  std::optional<GazeValidationRuns> validation;  ///< its times are of the steady clock
  ReactionPresses reaction;                      ///< its times are of the steady clock
  bool awaits_gaze = false;  ///< whether an armed trial waits, without a picture, for gaze
  NamedObject object;        ///< set while an object is chosen or is to be turned to
  TimedAgain timed_again = TimedAgain::no;  ///< why the trial is retimed
  Nanoseconds acknowledged_until{0};        ///< end of the message that a mark was taken
  bool wants_to_rate = false;
  Nanoseconds look_around_until{0};  ///< earliest time of the rating form
  std::optional<Nanoseconds>
      looked_around;  ///< time up to which the participant looked around before rating
};

/// Updates the prompt for an event that is durable; `context` is the state after it.
void follow(PromptState& prompt, const Event& event, const SessionContext& context);

/// Updates the prompt for the session's next effect: prepares its form or list, and queues the
/// notices before it. now: session clock.
void prepare(PromptState& prompt, const Effect& effect, const SessionContext& context,
             Nanoseconds now);

/// Shows the rating form. Returns false and does nothing if it is shown already, is not due, or the
/// participant is still to look around. now: session clock.
bool begin_rating(PromptState& prompt, const Protocol& protocol, Nanoseconds now);

/// Shows the first target at `start`, steady clock, if none is shown yet.
void begin_validation(PromptState& prompt, const ValidationSettings& settings,
                      const ViewGeometry& geometry, Nanoseconds start);

/// Returns whether the participant fills in the form in this phase.
bool is_form_shown(const PromptState& prompt, Phase phase);

/// Returns the event of the completed form in this phase; empty if consent was refused.
std::optional<Event> event_of_form(const PromptState& prompt, Phase phase,
                                   const Protocol& protocol);

}  // namespace foveola::study
