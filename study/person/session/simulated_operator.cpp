#include "study/person/session/simulated_operator.h"

#include <algorithm>

#include "renderer/base/angles.h"
#include "renderer/view/viewport.h"
#include "study/person/forms/typed_answer.h"
#include "study/person/session/object_pick.h"

namespace foveola::study {
namespace {

/// Events of a person at the machine, and requests to close the window.
bool is_of_a_hand(const WindowEvent& event) {
  return std::holds_alternative<KeyMoved>(event.what) ||
         std::holds_alternative<CharacterTyped>(event.what) ||
         std::holds_alternative<PointerMoved>(event.what) ||
         std::holds_alternative<MouseButtonMoved>(event.what) ||
         std::holds_alternative<GamepadMoved>(event.what) ||
         std::holds_alternative<CloseWanted>(event.what);
}

}  // namespace

SimulatedOperator::SimulatedOperator(const Parts& parts)
    : parts_(parts), conduct_(parts.protocol, parts.plan, parts.seed), zero_(parts.clock.now()) {}

Vec3 SimulatedOperator::gaze_in_head(Nanoseconds time) {
  return foveola::gaze_in_head(heading(time), parts_.participant.gaze(time - zero_));
}

bool SimulatedOperator::wants_to_look() const {
  return !due_ && !thought_.valid() &&
         (!last_glance_ || now() - *last_glance_ >= nanoseconds_from_seconds(glance_interval_s));
}

void SimulatedOperator::follow(SeenFrame frame, bool may_answer) {
  pass_on_window_events();
  finish_look();
  if (!may_answer) {
    return;
  }
  const PromptState& prompt = frame.prompt;
  if (prompt.confirmation) {
    press(FormKey::down);
    press(FormKey::enter);
  } else if (!prompt.notices.empty()) {
    press(PersonKey::confirm);
  } else {
    answer_frame(frame);
  }
}

void SimulatedOperator::answer_frame(SeenFrame& frame) {
  frame_ = &frame;
  conduct_.perform_action({.procedure = frame.context.procedure,
                           .state = frame.context.seen,
                           .now = frame.session_time,
                           .look_around_until = frame.prompt.look_around_until},
                          *this);
  frame_ = nullptr;
}

void SimulatedOperator::fill_in(const std::vector<Answer>& answers) {
  const Form& form = *frame_->prompt.form;
  if (const Question* question = form.question()) {
    for (const FormInput& input : typed_answer(*question, answers)) {
      events_.push(make_press(input, now()));
    }
  }
  press(FormKey::enter);
}

void SimulatedOperator::validate_gaze(const Attempt& attempt) {
  if (!frame_->prompt.validation) {
    target_.reset();
    begin_attempt(attempt);
    press(PersonKey::confirm);
    return;
  }
  const std::optional<Vec3> target = frame_->prompt.validation->target();
  if (target && target != target_) {
    participant().look_at(head_orientation(heading(now())) * *target, now() - zero_);
  }
  target_ = target;
}

void SimulatedOperator::react(std::uint32_t conduct) {
  const bool appeared = frame_->prompt.reaction.look() == ReactionLook::appeared;
  if (appeared && !has_reacted_) {
    due_ = frame_->shown + participant().react(conduct);
  }
  has_reacted_ = appeared;
  press_mark_when_due();
}

void SimulatedOperator::withdraw() {
  if (!withdraws_) {
    withdraws_ = true;
    press(PersonKey::pause);
  }
}

void SimulatedOperator::begin_attempt(const Attempt& attempt) {
  thought_ = {};  // of the previous attempt; destruction waits for it
  zero_ = now();
  object_.clear();
  parts_.participant.begin_attempt(attempt);
}

void SimulatedOperator::choose_object() {
  const std::string& scene = trial_at(frame_->context).scene;
  const std::size_t chosen = participant().choose_object(scene, *frame_->offered);
  turn_to(scene, (*frame_->offered)[chosen]);
  const Vec3 ahead = direction_from(heading(now()));
  if (is_settled() && object_ahead(*frame_->offered, ahead) == chosen) {
    press(PersonKey::confirm);
  }
}

void SimulatedOperator::start_trial() {
  turn_to(trial_at(frame_->context).scene,
          object_named(*frame_->offered, frame_->context.seen.object));
  if (is_settled()) {
    press(PersonKey::mark);
  }
}

void SimulatedOperator::ask_for_retime() {
  thought_ = {};  // of the previous mark
  press(PersonKey::back);
}

void SimulatedOperator::begin_task(Task task) {
  thought_ = {};  // of the previous mark
  due_.reset();
  last_glance_.reset();
  ratings_.reset();
  parts_.participant.begin(task, frame_->shown - zero_);
}

void SimulatedOperator::look_for_mark() {
  look();
  press_mark_when_due();
}

void SimulatedOperator::look_around() {
  if (!frame_->prompt.form) {
    look();
  }
}

void SimulatedOperator::rate() {
  if (frame_->prompt.form) {
    const std::vector<Question>& ratings = parts_.protocol.ratings;
    ratings_ = ratings_ ? ratings_ : participant().rate(ratings);
    fill_in(*ratings_);
  } else if (!frame_->prompt.wants_to_rate) {
    press(PersonKey::confirm);
  }
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

void SimulatedOperator::look() {
  if (!frame_->pixels || thought_.valid()) {
    return;
  }
  last_glance_ = frame_->shown;
  const Nanoseconds presented = frame_->shown - zero_;
  thought_ = std::async(std::launch::async, [&participant = parts_.participant,
                                             pixels = std::move(*frame_->pixels),
                                             gaze = parts_.participant.gaze(presented), presented] {
    return participant.see(
        {.image = pixels.image, .viewport = pixels.viewport, .gaze = gaze, .presented = presented});
  });
}

void SimulatedOperator::finish_look() {
  if (!thought_.valid() || thought_.wait_for(Nanoseconds(0)) != std::future_status::ready) {
    return;
  }
  if (const std::optional<Nanoseconds> press = thought_.get()) {
    due_ = zero_ + *press;
  }
}

void SimulatedOperator::press_mark_when_due() {
  if (due_ && now() >= *due_) {
    events_.push(make_press(PersonKey::mark, *due_));
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
