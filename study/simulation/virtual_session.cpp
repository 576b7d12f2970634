#include "study/simulation/virtual_session.h"

#include "study/driver/reaction_test.h"
#include "study/simulation/gaze_validation.h"

namespace foveola::study {

VirtualSession::VirtualSession(const SessionSetting& setting, const Plan& plan,
                               Participant& participant, const SessionPosition& position)
    : setting_(setting),
      participant_(participant),
      conduct_(setting.protocol, plan, setting.seed),
      attempt_start_(position.time),
      driver_({.protocol = setting.protocol, .plan = plan, .position = position, .notes = {}},
              *this, *this, *this, setting.recorder) {}

std::unique_ptr<AttemptPort> VirtualSession::begin_attempt() {
  std::unique_ptr<TrialAttempt> attempt = setting_.make_attempt(
      {.stage = stage(),
       .protocol = setting_.protocol,
       .trial = driver_.trial(),
       .object = object_named(stage().objects(), state().object),
       .seeds = {.tracker = seed_of_trial(SeedPurpose::tracker),
                 .rendering = seed_of_trial(SeedPurpose::rendering),
                 .picture = picture_seed(setting_.seed, setting_.protocol, driver_.trial())},
       .participant = participant_,
       .correction = driver_.correction(),
       .clock = clock_,
       .attempt_start = attempt_start_,
       .recorder = setting_.recorder,
       .key = driver_.attempt_key(),
       .pressed = pressed_});
  attempt_ = attempt.get();
  return attempt;
}

void VirtualSession::pass_input(SessionDriver& /*driver*/) {
  conduct_.perform_action({.procedure = driver_.procedure(),
                           .state = state(),
                           .now = now(),
                           .look_around_until = driver_.look_around_until()},
                          *this);
}

void VirtualSession::hand_in(const Questionnaire& form, const std::vector<Answer>& answers) {
  driver_.record_event(QuestionnaireAnswered{.questionnaire = form.id, .answers = answers});
}

void VirtualSession::validate_gaze(const Attempt& attempt) {
  begin_attempt(attempt);
  const std::optional<GazeValidated> validated = study::validate_gaze(
      setting_.protocol, participant_, step_seed(setting_.seed, SeedPurpose::tracker, state()),
      clock_, setting_.stop);
  if (validated) {
    driver_.record_event(*validated);
  }
}

void VirtualSession::react(std::uint32_t conduct) {
  Pcg32 random(step_seed(setting_.seed, SeedPurpose::waiting, state()));
  ReactionTest test(*setting_.protocol.reaction, now(), random);
  clock_.advance(test.due() - now());
  test.was_shown(now());
  clock_.advance(participant_.react(conduct));
  test.was_pressed(now());
  driver_.record_event(test.result().value());
}

void VirtualSession::begin_attempt(const Attempt& attempt) {
  attempt_start_ = now();
  clock_ = VirtualClock();
  participant_.begin_attempt(attempt);
}

void VirtualSession::choose_object() {
  const std::vector<OfferedObject>& objects = stage().objects();
  driver_.record_event(
      ObjectChosen{objects[participant_.choose_object(driver_.trial().scene, objects)].name});
}

void VirtualSession::start_trial() {
  setting_.on_trial(driver_.trial_index());
  participant_.turn_to(driver_.trial().scene, object_named(stage().objects(), state().object),
                       clock_.now());
  clock_.advance(nanoseconds_from_seconds(settling_s));
  driver_.record_event(TrialStarted{});
}

void VirtualSession::begin_task(Task task) {
  pressed_.reset();
  participant_.begin(task, clock_.now());
  attempt_->begin(task);
}

void VirtualSession::look_for_mark() {
  if (pressed_ && now() >= *pressed_) {
    driver_.mark(*pressed_);
  }
}

std::uint32_t VirtualSession::seed_of_trial(SeedPurpose purpose) const {
  return trial_seed(setting_.seed, purpose, setting_.protocol, driver_.trial(), state().timing);
}

}  // namespace foveola::study
