#include "study/person/simulated_operator.h"

#include <algorithm>

#include "renderer/base/angles.h"
#include "renderer/view/viewport.h"
#include "study/person/object_pick.h"
#include "study/person/typed_answer.h"
#include "study/stage/conduct.h"

namespace foveola::study {
namespace {

/// What a hand at the machine does, and a wish to close.
bool is_of_a_hand(const WindowEvent& event) {
  return std::holds_alternative<KeyMoved>(event.what) ||
         std::holds_alternative<CharacterTyped>(event.what) ||
         std::holds_alternative<PointerMoved>(event.what) ||
         std::holds_alternative<MouseButtonMoved>(event.what) ||
         std::holds_alternative<GamepadMoved>(event.what) ||
         std::holds_alternative<CloseWanted>(event.what);
}

}  // namespace

Vec3 SimulatedOperator::gaze_in_head(Nanoseconds time) {
  return foveola::gaze_in_head(heading(time), parts_.participant.gaze(time - zero_));
}

bool SimulatedOperator::wants_to_look() const {
  return !due_ && !thought_.valid() &&
         (!last_glance_ || now() - *last_glance_ >= nanoseconds_from_seconds(glance_interval_s));
}

void SimulatedOperator::follow(SeenFrame frame, bool may_answer) {
  pass_on_window_events();
  take_thought();
  if (!may_answer) {
    return;
  }
  const PromptState& prompt = frame.prompt;
  if (prompt.confirmation) {
    press(*prompt.confirmation == Confirmation::timing_again ? PersonKey::again : PersonKey::yes);
  } else if (!prompt.notices.empty()) {
    press(PersonKey::confirm);
  } else {
    answer(frame);
  }
}

void SimulatedOperator::answer(SeenFrame& frame) {
  const PromptState& prompt = frame.prompt;
  switch (frame.context.seen.phase) {
    case Phase::consent:
      fill_in(*prompt.form, {});
      break;
    case Phase::questionnaire: {
      const Questionnaire& form = questionnaire_of(parts_.protocol, prompt.form_of);
      fill_in(*prompt.form, participant().answer(form.id, form.questions));
      break;
    }
    case Phase::validation:
      look_at_targets(frame);
      break;
    case Phase::reaction:
      press_at_what_appears(frame);
      break;
    case Phase::choosing_object:
      choose_object(frame);
      break;
    case Phase::ready:
      get_ready(frame);
      break;
    case Phase::armed:
    case Phase::marking:
      watch(frame);
      break;
    case Phase::rating:
      rate(frame);
      break;
    case Phase::paused:
      press(withdraws_ ? PersonKey::back : PersonKey::confirm);
      break;
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      press(PersonKey::confirm);
      break;
    case Phase::created:
    case Phase::interrupted:
      break;
  }
}

void SimulatedOperator::fill_in(const Form& form, const std::vector<Answer>& answers) {
  if (const Question* question = form.question()) {
    for (const FormInput& input : typed_answer(*question, answers)) {
      events_.push(press_of(input, now()));
    }
  }
  events_.push(press_of(form.key_on(), now()));
}

void SimulatedOperator::look_at_targets(const SeenFrame& frame) {
  if (!frame.prompt.validation) {
    target_.reset();
    begin_attempt(attempt_at_validation(parts_.seed, frame.context.seen));
    press(PersonKey::confirm);
    return;
  }
  const std::optional<Vec3> target = frame.prompt.validation->target();
  if (target && target != target_) {
    participant().look_at(head_orientation(heading(now())) * *target, now() - zero_);
  }
  target_ = target;
}

void SimulatedOperator::press_at_what_appears(const SeenFrame& frame) {
  const bool appeared = frame.prompt.reaction.look() == ReactionLook::appeared;
  if (appeared && !has_reacted_) {
    due_ = frame.shown +
           participant().react(step_seed(parts_.seed, SeedPurpose::conduct, frame.context.seen));
  }
  has_reacted_ = appeared;
  press_mark_when_due();
}

void SimulatedOperator::choose_object(const SeenFrame& frame) {
  if (!enter_attempt(frame)) {
    return;
  }
  const std::string& scene = trial_at(frame.context).scene;
  const std::size_t chosen = participant().choose_object(scene, *frame.offered);
  turn_to(scene, (*frame.offered)[chosen]);
  const Vec3 ahead = direction_from(heading(now()));
  if (is_settled() && object_ahead(*frame.offered, ahead) == chosen) {
    press(PersonKey::confirm);
  }
}

void SimulatedOperator::get_ready(const SeenFrame& frame) {
  if (!enter_attempt(frame)) {
    return;
  }
  turn_to(trial_at(frame.context).scene, object_named(*frame.offered, frame.context.seen.object));
  if (is_settled()) {
    press(PersonKey::mark);
  }
}

void SimulatedOperator::watch(SeenFrame& frame) {
  const SessionState& seen = frame.context.seen;
  const Task task = task_of(parts_.protocol.marks[seen.mark]);
  if (!begin(task, {*attempt_, seen.mark}, frame.shown)) {
    return;
  }
  look(frame);
  press_mark_when_due();
}

void SimulatedOperator::rate(SeenFrame& frame) {
  if (frame.prompt.form) {
    const std::vector<Question>& ratings = parts_.protocol.ratings;
    ratings_ = ratings_ ? ratings_ : participant().rate(ratings);
    fill_in(*frame.prompt.form, *ratings_);
    return;
  }
  if (!begin(Task::look_around, {*attempt_, parts_.protocol.marks.size()}, frame.shown)) {
    return;
  }
  look(frame);
  if (frame.session_time >= frame.prompt.look_around_until && !frame.prompt.wants_to_rate) {
    press(PersonKey::confirm);
  }
}

bool SimulatedOperator::enter_attempt(const SeenFrame& frame) {
  const SessionState& seen = frame.context.seen;
  const AttemptOfTrial attempt(*trial_of(frame.context.procedure, seen), seen.attempt);
  if (attempt_ != attempt) {
    attempt_ = attempt;
    object_.clear();
    begin_attempt(
        attempt_at_trial(parts_.seed, parts_.protocol, frame.context.procedure, parts_.plan, seen));
    withdraws_ = participant().wants_to_withdraw(static_cast<int>(attempt.first));
    if (withdraws_) {
      press(PersonKey::pause);
    }
  }
  return !withdraws_;
}

void SimulatedOperator::begin_attempt(const Attempt& attempt) {
  thought_ = {};  // about the attempt before: who destroys it waits for it
  zero_ = now();
  participant().begin_attempt(attempt);
}

void SimulatedOperator::turn_to(const std::string& scene, const OfferedObject& object) {
  if (object_ != object.name) {
    object_ = object.name;
    turned_ = now();
    participant().turn_to(scene, object, turned_ - zero_);
  }
}

bool SimulatedOperator::is_settled() const {
  return now() - turned_ >= nanoseconds_from_seconds(settling_s);
}

bool SimulatedOperator::begin(Task task, const Mark& mark, Nanoseconds shown) {
  if (mark_ == mark) {
    return true;
  }
  thought_ = {};  // about the mark before
  if (mark.second > 0 && participant().wants_retime()) {
    press(PersonKey::again);
    return false;
  }
  mark_ = mark;
  due_.reset();
  last_glance_.reset();
  ratings_.reset();
  participant().begin(task, shown - zero_);
  return true;
}

void SimulatedOperator::look(SeenFrame& frame) {
  if (!frame.pixels || thought_.valid()) {
    return;
  }
  last_glance_ = frame.shown;
  const Nanoseconds presented = frame.shown - zero_;
  thought_ = std::async(std::launch::async, [&participant = parts_.participant,
                                             pixels = std::move(*frame.pixels),
                                             gaze = this->participant().gaze(presented),
                                             presented] {
    return participant.see(
        {.image = pixels.image, .viewport = pixels.viewport, .gaze = gaze, .presented = presented});
  });
}

void SimulatedOperator::take_thought() {
  if (!thought_.valid() || thought_.wait_for(Nanoseconds(0)) != std::future_status::ready) {
    return;
  }
  if (const std::optional<Nanoseconds> press = thought_.get()) {
    due_ = zero_ + *press;
  }
}

void SimulatedOperator::press_mark_when_due() {
  if (due_ && now() >= *due_) {
    events_.push(press_of(PersonKey::mark, *due_));
    due_.reset();
  }
}

void SimulatedOperator::pass_on_window_events() {
  for (const WindowEvent& event : parts_.window.take()) {
    if (!is_of_a_hand(event)) {
      events_.push(event);
    }
  }
}

}  // namespace foveola::study
