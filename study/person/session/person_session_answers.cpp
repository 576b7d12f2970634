// Input of a person's session: the participant's keys and the experimenter's commands.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "study/console/console_command.h"
#include "study/console/console_words.h"
#include "study/person/forms/form_input.h"
#include "study/person/prompts/person_keys.h"
#include "study/person/session/person_session.h"
#include "study/record/setup/routine_notes.h"

namespace foveola::study {

void PersonSession::pass_input(SessionDriver& driver) {
  follow_clocks(clock_watch_, seat_.read_clocks(), driver);
  answer_window();
  pause_if_due();
  answer_console();
}

void PersonSession::answer_console() {
  // A command, like a key, refers to the visible state.
  if (driver_.has_effects_to_come()) {
    return;
  }
  for (const std::string& line : console_.take_commands()) {
    const ConsoleAnswer answer = answer_to(line, {.participant = settings_.participant,
                                                  .state = driver_.state(),
                                                  .procedure = driver_.procedure(),
                                                  .plan = told_plan_});
    if (answer.quits) {
      driver_.interrupt();
    } else if (answer.event && std::holds_alternative<Resumed>(*answer.event) && !has_focus_) {
      console_.say(fmt::format("not possible now: {}", no_focus_line));
    } else if (answer.event && !driver_.record_event(*answer.event)) {
      console_.say(fmt::format("not possible now: {}",
                               words_for(driver_.state(), driver_.procedure(), told_plan_)));
    } else if (!answer.reply.empty()) {
      console_.say(answer.reply);
    }
  }
}

void PersonSession::note_tracker() {
  const bool is_lost = eye_.is_lost();
  if (is_lost != std::exchange(was_lost_, is_lost)) {
    driver_.record_event(NoteWritten{is_lost ? "the eye tracker sends no gaze"
                                             : "the eye tracker sends gaze again"});
  }
}

void PersonSession::answer_window() {
  for (const WindowEvent& event : seat_.events.take()) {
    answer(event);
  }
}

void PersonSession::answer(const WindowEvent& event) {
  answer_window_itself(event);
  viewer_.follow(event, is_picture_shown());
  std::optional<PersonKey> key = person_key(event);
  if (key || form_input(event)) {
    last_key_ = now();
  }
  if (key == PersonKey::pause) {
    pause_or_leave();
    return;
  }
  if (driver_.has_effects_to_come() || !page_watch_.was_seen_at(event.time)) {
    return;
  }
  const Phase phase = driver_.state().phase;
  if (prompt_.confirmation || is_form_shown(prompt_, phase)) {
    std::optional<FormInput> input = form_input(event);
    // A headset's controllers may have two buttons only.
    if (is_in_headset() && key == PersonKey::mark) {
      input = FormKey::step;
    }
    if (input && prompt_.confirmation) {
      answer_confirmation(*input);
    } else if (input) {
      prompt_.form->was_shown(event.time);
      if (prompt_.form->follow(*input)) {
        hand_in();
      }
    }
    return;
  }
  if (is_in_headset() && key == PersonKey::mark && phase == Phase::choosing_object) {
    key = PersonKey::next;
  }
  if (!key) {
    return;
  }
  if (const auto intent = intent_of(*key, phase, !prompt_.notices.empty())) {
    carry_out_intent(*intent, event.time);
  }
}

void PersonSession::answer_window_itself(const WindowEvent& event) {
  if (const auto* size = std::get_if<WindowResized>(&event.what)) {
    follow_size(*size);
  } else if (is_in_headset() && std::holds_alternative<WindowHidden>(event.what)) {
    return;
  } else if (const auto* hidden = std::get_if<WindowHidden>(&event.what)) {
    seat_.display.hide(hidden->is_hidden);
    driver_.record_event(
        NoteWritten{hidden->is_hidden ? "the window is hidden" : "the window is seen again"});
    is_pause_due_ = is_pause_due_ || hidden->is_hidden;
  } else if (const auto* focused = std::get_if<WindowFocused>(&event.what)) {
    follow_focus(focused->has_focus);
  } else if (const auto* lost = std::get_if<MonitorLost>(&event.what)) {
    driver_.record_event(NoteWritten{"lost the monitor " + lost->name});
    is_pause_due_ = true;
  } else if (const auto* headset = std::get_if<HeadsetChanged>(&event.what)) {
    follow_headset(headset->change);
  }
}

/// Times of marks must not run while keys go elsewhere. Controllers and simulated participants need
/// no focus.
void PersonSession::follow_focus(bool has_focus) {
  const bool needs_focus = !is_in_headset() && seat_.simulated_operator == nullptr;
  if (!needs_focus || has_focus == std::exchange(has_focus_, has_focus)) {
    return;
  }
  driver_.record_event(NoteWritten{has_focus ? "the window has the keyboard again"
                                             : "the window lost the keyboard: keys go elsewhere"});
  is_pause_due_ = is_pause_due_ || !has_focus;
}

/// Times of frames that the headset did not show are not counted.
void PersonSession::follow_headset(HeadsetChange change) {
  driver_.record_event(NoteWritten{words_for(change)});
  switch (change) {
    case HeadsetChange::got_focus:
    case HeadsetChange::put_on:
    case HeadsetChange::found:
      break;
    case HeadsetChange::exit_wanted:
      driver_.interrupt();
      break;
    default:
      is_pause_due_ = true;
      break;
  }
}

/// Pauses as soon as the session accepts it.
void PersonSession::pause_if_due() {
  if (is_pause_due_ && !driver_.has_effects_to_come()) {
    is_pause_due_ = false;
    driver_.record_event(PauseRequested{});
  }
}

void PersonSession::follow_size(const WindowResized& size) {
  if (is_in_headset() || size.framebuffer == seat_.display.framebuffer()) {
    return;
  }
  seat_.display.resize(size.framebuffer);
  viewer_.show(seat_.display.geometry(), size.framebuffer,
               static_cast<double>(size.framebuffer.x) / std::max(1, size.window.x));
  driver_.record_event(NoteWritten{note_of_window_size(size.framebuffer)});
}

void PersonSession::pause_or_leave() {
  if (driver_.has_effects_to_come()) {
    return;
  }
  if (driver_.state().is_over()) {
    driver_.leave();
  } else if (prompt_.confirmation) {
    end_confirmation();
  } else {
    driver_.record_event(PauseRequested{});
  }
}

void PersonSession::answer_confirmation(const FormInput& input) {
  if (input != FormInput(FormKey::enter)) {
    prompt_.confirmation->follow(input);
  } else if (const std::optional<Event> event = prompt_.confirmation->chosen()) {
    driver_.record_event(*event);
  } else {
    end_confirmation();
  }
}

void PersonSession::hand_in() {
  if (!prompt_.form->is_submitted()) {
    return;
  }
  const std::optional<Event> event = event_of_form(prompt_, driver_.state().phase, study_.protocol);
  if (!event) {
    prompt_.form.emplace(consent_form(study_.protocol.texts));
    ask_to_confirm(Confirmed::stopping);
  } else if (!driver_.record_event(*event)) {
    throw std::logic_error("the session refuses the event of a completed form");
  }
}

void PersonSession::carry_out_intent(KeyIntent intent, Nanoseconds time) {
  if (intent == KeyIntent::mark) {
    if (driver_.mark(time - zero_)) {
      judge_mark();
    }
    return;
  }
  if (const std::optional<Event> event = event_of(intent)) {
    driver_.record_event(*event);
    return;
  }
  switch (intent) {
    case KeyIntent::read_on:
      prompt_.notices.pop_front();
      page_watch_.turn_page();
      break;
    case KeyIntent::confirm_timing:
      ask_to_confirm(Confirmed::timing_again);
      break;
    case KeyIntent::confirm_stopping:
      ask_to_confirm(Confirmed::stopping);
      break;
    case KeyIntent::begin_validation:
      eye_.correct(std::nullopt);
      begin_validation(prompt_, *study_.protocol.tracker.validation, seat_.display.geometry(),
                       seat_.clock.now());
      break;
    case KeyIntent::press:
      prompt_.reaction.press(time);
      break;
    case KeyIntent::next_object:
      turn_to_next_object();
      break;
    case KeyIntent::choose_object:
      driver_.record_event(ObjectChosen{stage().objects()[object_ahead_now()].name});
      break;
    case KeyIntent::rate:
      prompt_.wants_to_rate = true;
      break;
    case KeyIntent::leave:
      driver_.leave();
      break;
    default:
      break;
  }
}

void PersonSession::turn_to_next_object() {
  const std::vector<OfferedObject>& objects = stage().objects();
  viewer_.turn_to(objects[(object_ahead_now() + 1) % objects.size()].direction, seat_.clock.now());
}

void PersonSession::ask_to_confirm(Confirmed what) {
  prompt_.confirmation.emplace(what, study_.protocol.texts);
  page_watch_.turn_page();
}

void PersonSession::end_confirmation() {
  prompt_.confirmation.reset();
  page_watch_.turn_page();
}

bool PersonSession::is_picture_shown() const {
  const Phase phase = driver_.state().phase;
  const bool is_in_scene = attempt_ != nullptr || phase == Phase::choosing_object ||
                           phase == Phase::ready || prompt_.awaits_gaze;
  return is_in_scene && !is_form_shown(prompt_, phase) && prompt_.notices.empty();
}

}  // namespace foveola::study
