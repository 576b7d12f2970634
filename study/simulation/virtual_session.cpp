#include "study/simulation/virtual_session.h"

#include <utility>

#include "study/driver/reaction_test.h"
#include "study/simulation/gaze_validation.h"
#include "study/stage/conduct.h"

namespace foveola::study {

/// Counts from the session's start, and says what the participant does at what is shown.
class VirtualSession::RunningAttempt final : public AttemptPort {
 public:
  RunningAttempt(VirtualSession& session, std::unique_ptr<TrialAttempt> attempt)
      : session_(session), attempt_(std::move(attempt)) {
    session_.attempt_ = attempt_.get();
  }
  ~RunningAttempt() override { session_.attempt_ = nullptr; }
  RunningAttempt(const RunningAttempt&) = delete;
  RunningAttempt& operator=(const RunningAttempt&) = delete;

  Nanoseconds show(Nanoseconds until) override {
    const std::optional<Nanoseconds> press = attempt_->show(until - session_.attempt_start_);
    if (press && !session_.pressed_) {
      session_.pressed_ = session_.attempt_start_ + *press;
    }
    return session_.now();
  }
  void before_end() override { attempt_->keep(); }
  void finish() override {}
  std::uint64_t samples() const override { return attempt_->samples(); }
  std::uint64_t non_finite() const override { return attempt_->non_finite(); }

 private:
  VirtualSession& session_;
  std::unique_ptr<TrialAttempt> attempt_;
};

VirtualSession::VirtualSession(const SessionSetting& setting, const Plan& plan,
                               Participant& participant, const SessionPosition& position)
    : setting_(setting),
      plan_(plan),
      participant_(participant),
      attempt_start_(position.time),
      driver_({.protocol = setting.protocol, .plan = plan, .position = position, .notes = {}},
              *this, *this, *this, setting.recorder) {}

std::unique_ptr<AttemptPort> VirtualSession::begin_attempt() {
  return std::make_unique<RunningAttempt>(
      *this, setting_.make_attempt({.stage = stage(),
                                    .protocol = setting_.protocol,
                                    .trial = driver_.trial(),
                                    .object = object_named(stage().objects(), state().object),
                                    .seeds = {.tracker = seed_of_trial(SeedPurpose::tracker),
                                              .rendering = seed_of_trial(SeedPurpose::rendering)},
                                    .participant = participant_,
                                    .correction = driver_.correction(),
                                    .clock = clock_,
                                    .attempt_start = attempt_start_,
                                    .recorder = setting_.recorder,
                                    .key = driver_.attempt_key()}));
}

void VirtualSession::act(SessionDriver& driver) {
  switch (state().phase) {
    case Phase::consent:
      driver.feed(ConsentGiven{});
      break;
    case Phase::questionnaire:
      answer_questionnaire();
      break;
    case Phase::validation:
      validate();
      break;
    case Phase::reaction:
      press();
      break;
    case Phase::choosing_object:
      choose_object();
      break;
    case Phase::ready:
      start_trial();
      break;
    case Phase::armed:
    case Phase::marking:
      mark();
      break;
    case Phase::rating:
      rate();
      break;
    case Phase::paused:
      driver.feed(Resumed{});
      break;
    case Phase::created:
    case Phase::interrupted:
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      driver.leave();
      break;
  }
}

void VirtualSession::answer_questionnaire() {
  const auto& step = std::get<QuestionnaireStep>(driver_.procedure().agenda[state().step]);
  const Questionnaire& form = questionnaire_of(setting_.protocol, step.questionnaire);
  driver_.feed(QuestionnaireAnswered{.questionnaire = form.id,
                                     .answers = participant_.answer(form.id, form.questions)});
}

void VirtualSession::validate() {
  restart(attempt_at_validation(setting_.seed, state()));
  const std::optional<GazeValidated> validated =
      validate_gaze(setting_.protocol, participant_,
                    step_seed(setting_.seed, SeedPurpose::tracker, state()), clock_, setting_.stop);
  if (validated) {
    driver_.feed(*validated);
  }
}

void VirtualSession::press() {
  Pcg32 random(step_seed(setting_.seed, SeedPurpose::waiting, state()));
  ReactionTest test(*setting_.protocol.reaction, now(), random);
  clock_.advance(test.due() - now());
  test.was_shown(now());
  clock_.advance(participant_.react(step_seed(setting_.seed, SeedPurpose::conduct, state())));
  test.was_pressed(now());
  driver_.feed(test.result().value());
}

void VirtualSession::choose_object() {
  if (withdraws()) {
    return;
  }
  const std::vector<OfferedObject>& objects = stage().objects();
  driver_.feed(
      ObjectChosen{objects[participant_.choose_object(driver_.trial().scene, objects)].name});
}

void VirtualSession::start_trial() {
  if (withdraws()) {
    return;
  }
  setting_.on_trial(driver_.trial_index());
  restart(attempt_at_trial(setting_.seed, setting_.protocol, driver_.procedure(), plan_, state()));
  participant_.turn_to(driver_.trial().scene, object_named(stage().objects(), state().object),
                       clock_.now());
  clock_.advance(nanoseconds_from_seconds(settling_s));
  driver_.feed(TrialStarted{});
}

void VirtualSession::mark() {
  begin(task_of(setting_.protocol.marks[state().mark]), state().mark);
  if (pressed_ && now() >= *pressed_ && driver_.mark(*pressed_) && participant_.wants_retime()) {
    driver_.feed(RetimeRequested{});
  }
}

void VirtualSession::rate() {
  begin(Task::look_around, setting_.protocol.marks.size());
  if (now() >= driver_.look_around_until()) {
    driver_.feed(Rated{participant_.rate(setting_.protocol.ratings)});
  }
}

bool VirtualSession::withdraws() {
  return participant_.wants_to_withdraw(static_cast<int>(driver_.trial_index())) &&
         driver_.feed(Withdrawn{});
}

void VirtualSession::restart(const Attempt& attempt) {
  attempt_start_ = now();
  clock_ = VirtualClock();
  task_.reset();
  participant_.begin_attempt(attempt);
}

void VirtualSession::begin(Task task, std::size_t index) {
  if (task_ != index) {
    task_ = index;
    pressed_.reset();
    participant_.begin(task, clock_.now());
    attempt_->begin(task);
  }
}

std::uint32_t VirtualSession::seed_of_trial(SeedPurpose purpose) const {
  return trial_seed(setting_.seed, purpose, setting_.protocol, driver_.trial(), state().timing);
}

}  // namespace foveola::study
