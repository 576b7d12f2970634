// What the participant is asked at the moment, and what is to be read before.
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

/// Each is there while it is needed. Times are of the session's clock.
struct PromptState {
  std::optional<Confirmation> confirmation;  ///< asked before everything else
  std::deque<ScreenPage> notices;            ///< to be read before anything is asked
  std::optional<Form> form;
  std::string form_of;  ///< the questionnaire's id; empty: consent, or the ratings
  std::optional<GazeValidationRuns> validation;  ///< its times are of the steady clock
  ReactionPresses reaction;                      ///< its times are of the steady clock
  bool awaits_gaze = false;  ///< whether an armed trial shows nothing until there is a gaze
  NamedObject object;        ///< while one is chosen or to be turned to
  TimedAgain timed_again = TimedAgain::no;  ///< why the trial is asked for again
  Nanoseconds acknowledged_until{0};        ///< until then it is shown that a mark was taken
  bool wants_to_rate = false;
  Nanoseconds look_around_until{0};          ///< the rating form does not come up before
  std::optional<Nanoseconds> looked_around;  ///< until it came up
};

/// An event is on the disk: `context` is after it.
void follow(PromptState& prompt, const Event& event, const SessionContext& context);

/// The session now waits for something else: makes ready what it asks for, and says what is to be
/// read before. now: session clock.
void prepare(PromptState& prompt, const Effect& effect, const SessionContext& context,
             Nanoseconds now);

/// The rating form comes up. Returns false, and does nothing, if it is there, not wanted yet, or to
/// be looked around before. now: session clock.
bool begin_rating(PromptState& prompt, const Protocol& protocol, Nanoseconds now);

/// The first target comes up, at `start` by the steady clock, if none is shown yet.
void begin_validation(PromptState& prompt, const ValidationSettings& settings,
                      const ViewGeometry& geometry, Nanoseconds start);

/// Whether the participant fills in the form in this phase.
bool is_form_shown(const PromptState& prompt, Phase phase);

/// What the form that was filled in says in this phase; empty if no consent was given.
std::optional<Event> event_of_form(const PromptState& prompt, Phase phase,
                                   const Protocol& protocol);

}  // namespace foveola::study
