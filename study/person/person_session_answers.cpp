// What the participant's keys and the experimenter's words do.
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "study/person/console_words.h"
#include "study/person/person_session.h"

namespace foveola::study {
namespace {

/// Events that only steer must not turn the head below a page, but what was held may be let go.
bool turns_head(const WindowEvent& event) {
  const auto* key = std::get_if<KeyMoved>(&event.what);
  return key != nullptr && key->is_down;
}

}  // namespace

void PersonSession::answer_console() {
  // A command is about what can be seen, like a key.
  if (log_.has_effects_to_come()) {
    return;
  }
  for (const std::string& line : parts_.console->take()) {
    if (const auto command = parse_console_line(line)) {
      answer(*command);
    } else if (!line.empty()) {
      parts_.tell("What is '" + line + "'? help says what there is.");
    }
  }
}

void PersonSession::answer(const ConsoleCommand& command) {
  const auto try_to = [this](const Event& event) {
    if (!feed(event)) {
      parts_.tell(fmt::format("not possible now: {}",
                              words_for(log_.state(), log_.procedure(), *parts_.plan)));
    }
  };
  switch (command.action) {
    case ConsoleAction::state:
      parts_.tell(words_for(log_.state(), log_.procedure(), *parts_.plan));
      break;
    case ConsoleAction::next:
      parts_.tell(words_for_next(log_.state(), log_.procedure(), *parts_.plan));
      break;
    case ConsoleAction::note:
      try_to(NoteWritten{command.text});
      break;
    case ConsoleAction::pause:
      try_to(PauseRequested{});
      break;
    case ConsoleAction::resume:
      try_to(Resumed{});
      break;
    case ConsoleAction::retime:
      try_to(RetimeRequested{});
      break;
    case ConsoleAction::exclude:
      try_to(Excluded{command.text});
      break;
    case ConsoleAction::withdraw:
      try_to(Withdrawn{});
      break;
    case ConsoleAction::quit:
      interrupt();
      break;
    case ConsoleAction::help:
      parts_.tell(console_help());
      break;
  }
}

void PersonSession::tell_of_tracker() {
  const bool is_lost = parts_.eye->is_lost();
  if (is_lost == was_lost_) {
    return;
  }
  was_lost_ = is_lost;
  feed(NoteWritten{is_lost ? "the eye tracker sends no gaze" : "the eye tracker sends gaze again"});
  const std::string trouble = parts_.eye->trouble();
  if (is_lost) {
    parts_.tell(
        fmt::format("The eye tracker sends no gaze{}{}. The session goes on; pause if it "
                    "should not.",
                    trouble.empty() ? "" : ": ", trouble));
  }
}

void PersonSession::answer_window() {
  for (const WindowEvent& event : parts_.events->take()) {
    answer(event);
  }
}

void PersonSession::answer(const WindowEvent& event) {
  answer_window_itself(event);
  if (is_picture_shown() || !turns_head(event)) {
    viewer_->steering.follow(event);
  }
  const std::optional<PersonKey> key = person_key(event);
  if (key == PersonKey::pause) {
    pause_or_leave();
    return;
  }
  // What was pressed before the page could be seen was no answer to it.
  if (log_.has_effects_to_come() || !page_shown_ || event.time < *page_shown_) {
    return;
  }
  if (is_form_shown()) {
    const std::optional<FormInput> input = form_input(event);
    if (input && form_->follow(*input)) {
      hand_in();
      return;
    }
  }
  if (key) {
    press(*key, event.time);
  }
}

void PersonSession::answer_window_itself(const WindowEvent& event) {
  if (const auto* size = std::get_if<WindowResized>(&event.what)) {
    follow_size(*size);
  } else if (const auto* hidden = std::get_if<WindowHidden>(&event.what)) {
    parts_.display->hide(hidden->is_hidden);
    feed(NoteWritten{hidden->is_hidden ? "the window is hidden" : "the window is seen again"});
  } else if (const auto* lost = std::get_if<MonitorLost>(&event.what)) {
    feed(NoteWritten{"lost the monitor " + lost->name});
    pause_or_leave();
  }
}

void PersonSession::follow_size(const WindowResized& size) {
  if (size.framebuffer == parts_.display->framebuffer()) {
    return;
  }
  parts_.display->resize(size.framebuffer);
  pixels_per_unit_ = static_cast<double>(size.framebuffer.x) / std::max(1, size.window.x);
  viewer_->steering.show(parts_.display->geometry(), size.framebuffer, pixels_per_unit_);
  feed(NoteWritten{
      fmt::format("the window has {} x {} pixels", size.framebuffer.x, size.framebuffer.y)});
}

void PersonSession::pause_or_leave() {
  if (log_.has_effects_to_come()) {
    return;
  }
  if (log_.state().is_over()) {
    is_done_ = true;
  } else if (doubt_) {
    doubt_.reset();
    show_new_page();
  } else {
    feed(PauseRequested{});
  }
}

void PersonSession::press(PersonKey key, Nanoseconds time) {
  if (doubt_) {
    press_in_doubt(key);
    return;
  }
  if (!notices_.empty()) {
    if (key == PersonKey::mark || key == PersonKey::confirm) {
      notices_.pop_front();
      show_new_page();
    }
    return;
  }
  switch (log_.state().phase) {
    case Phase::consent:
      if (key == PersonKey::no) {
        ask_to_confirm(Doubt::stopping);
      }
      break;
    case Phase::validation:
      if (key == PersonKey::mark || key == PersonKey::confirm) {
        begin_validation();
      }
      break;
    case Phase::reaction:
      if (key == PersonKey::mark && reaction_) {
        reaction_->was_pressed(time);
      }
      break;
    case Phase::choosing_object:
      press_while_choosing(key);
      break;
    case Phase::ready:
      if (key == PersonKey::mark) {
        feed(TrialStarted{});
      }
      break;
    case Phase::marking:
      press_while_marking(key, time);
      break;
    case Phase::rating:
      press_while_looking_around(key);
      break;
    case Phase::paused:
      press_while_paused(key);
      break;
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      is_done_ = key == PersonKey::confirm;
      break;
    case Phase::created:
    case Phase::questionnaire:
    case Phase::armed:
    case Phase::interrupted:
      break;
  }
}

void PersonSession::press_in_doubt(PersonKey key) {
  const bool is_of_timing = *doubt_ == Doubt::timing_again;
  if (key == (is_of_timing ? PersonKey::again : PersonKey::yes)) {
    feed(is_of_timing ? Event(RetimeRequested{}) : Event(Withdrawn{}));
  } else if (key == (is_of_timing ? PersonKey::back : PersonKey::no)) {
    doubt_.reset();
    show_new_page();
  }
}

void PersonSession::press_while_choosing(PersonKey key) {
  const std::vector<OfferedObject>& objects = stage().objects();
  if (key == PersonKey::next) {
    turn_to(objects[(object_ahead_now() + 1) % objects.size()].direction);
  } else if (key == PersonKey::confirm) {
    feed(ObjectChosen{objects[object_ahead_now()].name});
  }
}

std::size_t PersonSession::object_ahead_now() const {
  const Quat head = head_orientation(viewer_->head.pose(parts_.clock->now()).heading);
  return object_ahead(stage().objects(), head * Vec3(0.0F, 0.0F, -1.0F));
}

void PersonSession::turn_to(const Vec3& direction) {
  const Nanoseconds time = parts_.clock->now();
  const AzimuthElevation there = azimuth_elevation(direction);
  const AzimuthElevation here = viewer_->head.pose(time).heading;
  viewer_->head.turn(time, {.right_rad = wrapped_angle(there.azimuth_rad - here.azimuth_rad),
                            .up_rad = there.elevation_rad - here.elevation_rad});
}

void PersonSession::press_while_marking(PersonKey key, Nanoseconds time) {
  if (key == PersonKey::mark) {
    feed(Marked{in_session(time)});
  } else if (key == PersonKey::again) {
    ask_to_confirm(Doubt::timing_again);
  }
}

void PersonSession::press_while_looking_around(PersonKey key) {
  if (key == PersonKey::confirm) {
    wants_to_rate_ = true;
  } else if (key == PersonKey::again) {
    ask_to_confirm(Doubt::timing_again);
  }
}

void PersonSession::press_while_paused(PersonKey key) {
  if (key == PersonKey::mark || key == PersonKey::confirm) {
    feed(Resumed{});
  } else if (key == PersonKey::back) {
    ask_to_confirm(Doubt::stopping);
  }
}

void PersonSession::ask_to_confirm(Doubt doubt) {
  doubt_ = doubt;
  show_new_page();
}

void PersonSession::begin_validation() {
  if (validation_) {
    return;
  }
  const ViewGeometry& geometry = parts_.display->geometry();
  parts_.eye->correct(std::nullopt);
  validation_.emplace(*parts_.protocol->tracker.validation, geometry.horizontal_fov_deg,
                      geometry.vertical_fov_deg, parts_.clock->now());
}

void PersonSession::hand_in() {
  if (!form_->is_submitted()) {
    return;
  }
  const Phase phase = log_.state().phase;
  const Event event = phase == Phase::consent ? Event(ConsentGiven{})
                      : phase == Phase::rating
                          ? Event(Rated{form_->answers()})
                          : Event(QuestionnaireAnswered{form_of_, form_->answers()});
  if (!feed(event)) {
    throw std::logic_error("the session does not take what a form was filled in with");
  }
}

bool PersonSession::is_form_shown() const {
  const Phase phase = log_.state().phase;
  const bool asks =
      phase == Phase::consent || phase == Phase::questionnaire || phase == Phase::rating;
  return form_ && asks && !doubt_ && notices_.empty();
}

bool PersonSession::is_picture_shown() const {
  const Phase phase = log_.state().phase;
  const bool is_in_scene =
      attempt_ != nullptr || phase == Phase::choosing_object || phase == Phase::ready;
  return is_in_scene && !is_form_shown() && notices_.empty();
}

}  // namespace foveola::study
