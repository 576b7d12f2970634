#include "study/participant/conduct.h"

#include "study/participant/answers.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// The task until this mark is made. With drawn times, for a mark that is not judged, the eyes stay
/// on the object as for its material.
Task task_of(const MarkEntry& mark) { return judgement_of(mark).value_or(Task::mark_material); }

const Questionnaire& form_in(const Protocol& protocol, const SessionMoment& moment) {
  const auto& step = std::get<QuestionnaireStep>(moment.procedure.agenda[moment.state.step]);
  return questionnaire_of(protocol, step.questionnaire);
}

}  // namespace

void SimulatedConduct::perform_action(const SessionMoment& moment, ParticipantActions& actions) {
  const SessionState& state = moment.state;
  switch (state.phase) {
    case Phase::consent:
      actions.consent();
      break;
    case Phase::questionnaire: {
      const Questionnaire& form = form_in(protocol_, moment);
      actions.hand_in(form, actions.participant().answer(form.id, form.questions));
      break;
    }
    case Phase::validation:
      actions.validate_gaze(
          {.conduct = step_seed(seed_, SeedPurpose::conduct, state), .trials_before = 0});
      break;
    case Phase::reaction:
      actions.react(step_seed(seed_, SeedPurpose::conduct, state));
      break;
    case Phase::choosing_object:
      if (enter_attempt(moment, actions)) {
        actions.choose_object();
      }
      break;
    case Phase::ready:
      if (enter_attempt(moment, actions)) {
        actions.start_trial();
      }
      break;
    case Phase::armed:
    case Phase::marking:
      if (enter_task(task_of(protocol_.marks[state.mark]), state.mark, moment, actions)) {
        actions.look_for_mark();
      }
      break;
    case Phase::rating:
      if (enter_task(Task::look_around, protocol_.marks.size(), moment, actions)) {
        actions.look_around();
        if (moment.now >= moment.look_around_until) {
          actions.rate();
        }
      }
      break;
    case Phase::paused:
      actions.resume();
      break;
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      actions.leave();
      break;
    case Phase::created:
    case Phase::interrupted:
      break;
  }
}

SimulatedConduct::AttemptOfTrial SimulatedConduct::attempt_in(const SessionMoment& moment) const {
  return {trial_of(moment.procedure, moment.state).value(), moment.state.attempt};
}

bool SimulatedConduct::enter_attempt(const SessionMoment& moment, ParticipantActions& actions) {
  const AttemptOfTrial attempt = attempt_in(moment);
  const int trials_before = static_cast<int>(attempt.first);
  if (actions.participant().wants_to_withdraw(trials_before)) {
    actions.withdraw();
    return false;
  }
  if (attempt_ != attempt) {
    attempt_ = attempt;
    actions.begin_attempt({.conduct = trial_seed(seed_, SeedPurpose::conduct, protocol_,
                                                 trial_in(moment), moment.state.timing),
                           .trials_before = trials_before});
  }
  return true;
}

bool SimulatedConduct::enter_task(Task task, std::size_t index, const SessionMoment& moment,
                                  ParticipantActions& actions) {
  const TaskOfAttempt task_of_attempt(attempt_in(moment), index);
  if (task_ == task_of_attempt) {
    return true;
  }
  if (index > 0 && regrets_last_mark(moment, actions)) {
    actions.ask_for_retime();
    return false;
  }
  task_ = task_of_attempt;
  actions.begin_task(task);
  return true;
}

bool SimulatedConduct::regrets_last_mark(const SessionMoment& moment,
                                         ParticipantActions& actions) const {
  const Nanoseconds deadline = moment.state.first_frame + nanoseconds_from_seconds(mark_timeout_s(
                                                              protocol_, trial_in(moment)));
  return moment.state.last_mark < deadline && actions.participant().wants_retime();
}

}  // namespace foveola::study
