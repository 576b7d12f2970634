#include "study/session/session.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "renderer/base/files/digest.h"
#include "study/protocol/texts.h"

namespace foveola::study {
namespace {

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
// NOLINTNEXTLINE(readability-identifier-naming): a deduction guide has its class's name.
Overloaded(Functions...) -> Overloaded<Functions...>;

using Result = std::optional<Transition>;

/// Whether an attempt at a trial is going on.
bool is_rendering(Phase phase) {
  return phase == Phase::armed || phase == Phase::marking || phase == Phase::rating;
}

bool is_left_off(Phase phase) { return phase == Phase::paused || phase == Phase::interrupted; }

/// The state in which a step of the agenda begins; behind the last, the session is completed.
SessionState at_step(const Procedure& procedure, std::size_t step, const std::string& object) {
  SessionState state;
  state.step = step;
  state.object = object;
  if (step == procedure.agenda.size()) {
    state.phase = Phase::completed;
    return state;
  }
  std::visit(Overloaded{
                 [&](const ConsentStep&) { state.phase = Phase::consent; },
                 [&](const QuestionnaireStep&) { state.phase = Phase::questionnaire; },
                 [&](const ValidationStep& validation) {
                   state.phase = Phase::validation;
                   state.validations_left = validation.attempts;
                 },
                 [&](const ReactionStep& reaction) {
                   state.phase = Phase::reaction;
                   state.presses_left = reaction.presses;
                 },
                 [&](const TrialStep& trial) {
                   state.phase = trial.chooses_object ? Phase::choosing_object : Phase::ready;
                 },
             },
             procedure.agenda[step]);
  return state;
}

const std::string& questionnaire_at(const Procedure& procedure, const SessionState& state) {
  return std::get<QuestionnaireStep>(procedure.agenda[state.step]).questionnaire;
}

/// What is asked of the participant in a state that waits for an answer.
std::vector<Effect> asking(const Procedure& procedure, const SessionState& state) {
  switch (state.phase) {
    case Phase::consent:
      return {AskForConsent{}};
    case Phase::questionnaire:
      return {AskQuestionnaire{questionnaire_at(procedure, state)}};
    case Phase::validation:
      return {ValidateGaze{}};
    case Phase::reaction:
      return {AskForPress{}};
    case Phase::choosing_object:
      return {AskForObject{}};
    case Phase::ready:
      return {AskWhetherReady{}};
    case Phase::completed:
      return {EndSession{}};
    default:
      return {};
  }
}

Transition ask(const Procedure& procedure, SessionState state) {
  std::vector<Effect> effects = asking(procedure, state);
  return {.state = std::move(state), .effects = std::move(effects)};
}

Transition next_step(const Procedure& procedure, const SessionState& state) {
  return ask(procedure, at_step(procedure, state.step + 1, state.object));
}

/// The same trial, not yet begun again.
SessionState before_next_attempt(const Procedure& procedure, const SessionState& state) {
  SessionState again = at_step(procedure, state.step, state.object);
  again.phase = Phase::ready;
  again.attempt = state.attempt + 1;
  again.timing = state.timing;
  return again;
}

/// What an attempt that goes on has to end with.
std::vector<Effect> stop_rendering(Phase phase) {
  return is_rendering(phase) ? std::vector<Effect>{StopRendering{}} : std::vector<Effect>{};
}

/// A pause, or an end: where the session can go on from is kept.
Transition leave_off(const Procedure& procedure, SessionState state, Phase phase,
                     const Effect& last) {
  std::vector<Effect> effects = stop_rendering(state.phase);
  effects.push_back(last);
  if (is_rendering(state.phase)) {
    state = before_next_attempt(procedure, state);
  }
  if (!is_left_off(state.phase)) {
    state.resumes_at = state.phase;
  }
  state.phase = phase;
  return {.state = std::move(state), .effects = std::move(effects)};
}

bool all_answered(const std::vector<Question>& questions, const std::vector<Answer>& answers) {
  const auto answers_to = [&](const Question& question) {
    return std::ranges::count_if(answers, [&](const Answer& answer) {
      return answer.question == question.id && fault_of(question, answer.value).empty();
    });
  };
  std::ptrdiff_t good_answers = 0;
  for (const Question& question : questions) {
    const std::ptrdiff_t count = answers_to(question);
    if (count > 1 || (count == 0 && question.required)) {
      return false;
    }
    good_answers += count;
  }
  return good_answers == static_cast<std::ptrdiff_t>(answers.size());
}

/// What each event does; of those in a state that is over, EndUndone alone.
class Step {
 public:
  Step(const Procedure& procedure, const SessionState& state)
      : procedure_(procedure), state_(state) {}

  Result operator()(const SessionStarted& /*event*/) const {
    return in(Phase::created, [&] { return ask(procedure_, at_step(procedure_, 0, {})); });
  }

  Result operator()(const ConsentGiven& /*event*/) const {
    return in(Phase::consent, [&] {
      if (state_.after_consent == Phase::created) {
        return next_step(procedure_, state_);
      }
      SessionState after = state_;
      after.phase = std::exchange(after.after_consent, Phase::created);
      return ask(procedure_, after);
    });
  }

  Result operator()(const QuestionnaireAnswered& event) const {
    return in(Phase::questionnaire, [&]() -> Result {
      if (event.questionnaire != questionnaire_at(procedure_, state_)) {
        return std::nullopt;
      }
      return next_step(procedure_, state_);
    });
  }

  Result operator()(const GazeValidated& event) const {
    return in(Phase::validation, [&] {
      if (event.passed) {
        return next_step(procedure_, state_);
      }
      SessionState again = state_;
      --again.validations_left;
      return again.validations_left == 0
                 ? leave_off(procedure_, again, Phase::refused, EndSession{})
                 : ask(procedure_, again);
    });
  }

  Result operator()(const ReactionPressed& event) const {
    return in(Phase::reaction, [&] {
      SessionState again = state_;
      again.presses_left -= event.time < event.shown ? 0 : 1;
      return again.presses_left == 0 ? next_step(procedure_, state_) : ask(procedure_, again);
    });
  }

  Result operator()(const ObjectChosen& event) const {
    return in(Phase::choosing_object, [&]() -> Result {
      if (event.object.empty()) {
        return std::nullopt;
      }
      SessionState ready = state_;
      ready.phase = Phase::ready;
      ready.object = event.object;
      return ask(procedure_, ready);
    });
  }

  Result operator()(const TrialStarted& /*event*/) const {
    return in(Phase::ready, [&] {
      SessionState armed = state_;
      armed.phase = Phase::armed;
      return Transition{.state = armed, .effects = {StartRendering{}}};
    });
  }

  Result operator()(const FirstFramePresented& event) const {
    return in(Phase::armed, [&] {
      SessionState marking = state_;
      marking.phase = Phase::marking;
      marking.first_frame = event.time;
      marking.last_mark = event.time;
      return Transition{.state = marking, .effects = {}};
    });
  }

  Result operator()(const Marked& event) const { return mark(event.time, {AcknowledgeMark{}}); }
  Result operator()(const TimedOut& event) const { return mark(event.time, {}); }

  Result operator()(const Rated& event) const {
    return in(Phase::rating, [&]() -> Result {
      if (!all_answered(procedure_.ratings, event.answers)) {
        return std::nullopt;
      }
      Transition next = next_step(procedure_, state_);
      next.effects.insert(next.effects.begin(), StopRendering{});
      return next;
    });
  }

  Result operator()(const RetimeRequested& /*event*/) const {
    if (state_.phase != Phase::marking && state_.phase != Phase::rating) {
      return std::nullopt;
    }
    SessionState again = before_next_attempt(procedure_, state_);
    ++again.timing;
    return Transition{.state = again, .effects = {StopRendering{}, AskWhetherReady{}}};
  }

  Result operator()(const PauseRequested& /*event*/) const {
    if (state_.phase == Phase::created || is_left_off(state_.phase)) {
      return std::nullopt;
    }
    return leave_off(procedure_, state_, Phase::paused, ShowPause{});
  }

  Result operator()(const Interrupted& /*event*/) const {
    return leave_off(procedure_, state_, Phase::interrupted, EndSession{});
  }

  Result operator()(const Resumed& /*event*/) const {
    if (!is_left_off(state_.phase)) {
      return std::nullopt;
    }
    SessionState resumed = state_;
    resumed.phase = state_.resumes_at;
    resumed.resumes_at = Phase::created;
    return ask(procedure_, resumed);
  }

  Result operator()(const NoteWritten& /*event*/) const {
    return Transition{.state = state_, .effects = {}};
  }

  Result operator()(const Withdrawn& /*event*/) const {
    return leave_off(procedure_, state_, Phase::withdrawn, EndSession{});
  }

  Result operator()(const Excluded& /*event*/) const {
    return leave_off(procedure_, state_, Phase::excluded, EndSession{});
  }

  Result operator()(const EndUndone& /*event*/) const {
    if (state_.phase != Phase::withdrawn && state_.phase != Phase::excluded) {
      return std::nullopt;
    }
    SessionState paused = state_;
    paused.phase = Phase::paused;
    return Transition{.state = paused, .effects = {ShowPause{}}};
  }

  Result operator()(const ConsentAsked& /*event*/) const {
    const auto begin = procedure_.agenda.begin();
    const auto here = begin + static_cast<std::ptrdiff_t>(state_.step);
    const bool was_given = std::any_of(begin, here, [](const AgendaStep& step) {
      return std::holds_alternative<ConsentStep>(step);
    });
    if (!is_left_off(state_.phase) || !was_given || state_.resumes_at == Phase::consent) {
      return std::nullopt;
    }
    SessionState asked = state_;
    asked.after_consent = std::exchange(asked.resumes_at, Phase::consent);
    return Transition{.state = asked, .effects = {}};
  }

 private:
  /// The event is of this phase alone.
  template <typename Work>
  Result in(Phase phase, const Work& work) const {
    return state_.phase == phase ? Result(work()) : std::nullopt;
  }

  /// The mark that is waited for, or its time-out.
  Result mark(Nanoseconds time, std::vector<Effect> effects) const {
    return in(Phase::marking, [&]() -> Result {
      if (time < state_.last_mark) {
        return std::nullopt;
      }
      SessionState marked = state_;
      marked.last_mark = time;
      ++marked.mark;
      if (marked.mark == procedure_.marks) {
        marked.phase = Phase::rating;
        effects.emplace_back(AskForRating{});
      }
      return Transition{.state = marked, .effects = effects};
    });
  }

  const Procedure& procedure_;
  const SessionState& state_;
};

}  // namespace

const char* name_of(Phase phase) {
  constexpr std::array names = {"created",   "consent",         "questionnaire", "validation",
                                "reaction",  "choosing_object", "ready",         "armed",
                                "marking",   "rating",          "paused",        "interrupted",
                                "completed", "withdrawn",       "excluded",      "refused"};
  return names.at(static_cast<std::size_t>(phase));
}

Nanoseconds time_of(const Event& event, Nanoseconds now) {
  return std::visit(
      [now](const auto& e) {
        if constexpr (requires { e.time; }) {
          return e.time;
        } else {
          return now;
        }
      },
      event);
}

const char* name_of(const Event& event) {
  constexpr std::array names = {"session_started",
                                "consent_given",
                                "questionnaire_answered",
                                "gaze_validated",
                                "reaction_pressed",
                                "object_chosen",
                                "trial_started",
                                "first_frame_presented",
                                "marked",
                                "timed_out",
                                "rated",
                                "retime_requested",
                                "pause_requested",
                                "interrupted",
                                "resumed",
                                "note_written",
                                "withdrawn",
                                "excluded",
                                "end_undone",
                                "consent_asked"};
  static_assert(names.size() == std::variant_size_v<Event>);
  return names.at(event.index());
}

ConsentGiven consent_to(const Protocol& protocol) {
  return {.text_sha256 = sha256(text_of(protocol.texts, "consent")), .language = protocol.language};
}

std::optional<GazeCorrection> correction_after(const GazeValidated& validation) {
  return validation.passed ? validation.runs.back().correction : std::nullopt;
}

Procedure procedure_of(const Protocol& protocol, const Plan& plan) {
  return {.agenda = agenda_of(protocol, plan),
          .marks = protocol.marks.size(),
          .ratings = protocol.ratings};
}

std::optional<Transition> step(const Procedure& procedure, const SessionState& state,
                               const Event& event) {
  assert(!procedure.agenda.empty() && procedure.marks > 0);
  const bool may_follow = !state.is_over() || std::holds_alternative<EndUndone>(event);
  return may_follow ? std::visit(Step(procedure, state), event) : std::nullopt;
}

std::optional<std::size_t> trial_of(const Procedure& procedure, const SessionState& state) {
  const Phase phase = is_left_off(state.phase) ? state.resumes_at : state.phase;
  if (phase == Phase::created || phase == Phase::consent || state.is_over()) {
    return std::nullopt;
  }
  const auto* trial = std::get_if<TrialStep>(&procedure.agenda[state.step]);
  return trial != nullptr ? std::optional(trial->trial) : std::nullopt;
}

}  // namespace foveola::study
