// What keys, the mouse and changes of the window and of the headset do to the live preview.
#include <variant>

#include "renderer/window/live/live_preview.h"

namespace foveola {

void LivePreview::answer_events() {
  follow_change();
  report_pictures();
  for (const WindowEvent& event : parts_.events->take()) {
    if (!parts_.camera->follow(event)) {
      parts_.steering->follow(event);
      answer(event);
    }
  }
  move_camera();
  // Methods that follow the pointer use it in the last frame's view.
  if (const std::optional<Vec3> pointer = parts_.steering->pointer()) {
    parts_.preview->point_at(glm::normalize(parts_.preview->viewport().head() * *pointer));
  }
}

void LivePreview::answer(const WindowEvent& event) {
  if (const auto* typed = std::get_if<CharacterTyped>(&event.what)) {
    if (const auto action = action_of(*typed)) {
      act(*action);
    }
  } else if (const auto* key = std::get_if<KeyMoved>(&event.what)) {
    answer(*key);
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event.what)) {
    zoom(wheel->away);
  } else if (const auto* size = std::get_if<WindowResized>(&event.what)) {
    follow_size(*size);
  } else if (const auto* hidden = std::get_if<WindowHidden>(&event.what)) {
    area_.is_hidden = hidden->is_hidden && !is_in_headset();
  } else if (const auto* lost = std::get_if<MonitorLost>(&event.what)) {
    tell("lost the monitor " + lost->name, MessageStay::long_enough);
    report_.lost_monitors.push_back(lost->name);
  } else if (const auto* found = std::get_if<MonitorFound>(&event.what)) {
    tell("found the monitor " + found->name, MessageStay::long_enough);
  } else if (std::holds_alternative<CloseWanted>(event.what)) {
    is_done_ = true;
  } else if (const auto* headset = std::get_if<HeadsetChanged>(&event.what)) {
    answer(headset->change);
  }
}

void LivePreview::answer(HeadsetChange change) {
  is_done_ = is_done_ || change == HeadsetChange::exit_wanted;
  report_.headset_changes.push_back(change);
  tell(words_for(change), MessageStay::long_enough);
}

/// A headset's content does not depend on the window that mirrors it.
void LivePreview::follow_size(const WindowResized& size) {
  if (!is_in_headset()) {
    area_.framebuffer = size.framebuffer;
  }
  if (WindowArea{.framebuffer = size.framebuffer}.has_room()) {
    window_ = size;
    view_.resize(area_.framebuffer);
    show_view();
  }
}

void LivePreview::answer(const KeyMoved& key) {
  const std::optional<PreviewAction> action = action_of(key);
  if (key.is_down) {
    messages_.answer_key();
  }
  if (action == PreviewAction::close && check_.is_running()) {
    end_check();
    tell("the check was ended");
  } else if (action) {
    act(*action);
  }
}

void LivePreview::act(PreviewAction action) {
  if (follow(action, choices_)) {
    restart();
  }
  switch (action) {
    case PreviewAction::freeze_gaze:
      parts_.preview->hold_gaze(choices_.gaze_is_frozen);
      break;
    case PreviewAction::fit_view:
      parts_.camera->fit(parts_.clock->now());
      break;
    case PreviewAction::first_view:
      parts_.camera->go_back(parts_.clock->now());
      view_.show_first();
      show_view();
      break;
    case PreviewAction::first_field_of_view:
      view_.show_first();
      show_view();
      tell(view_.in_words());
      break;
    case PreviewAction::true_angles:
      view_.show_true_angles();
      show_view();
      tell(view_.in_words());
      break;
    case PreviewAction::print_view:
      print(view_options(shown_now()));
      tell("printed the view as options");
      break;
    case PreviewAction::check_gaze:
      begin_check();
      break;
    case PreviewAction::take_picture:
      wants_picture_ = true;
      break;
    case PreviewAction::toggle_full_screen:
      parts_.window->toggle_full_screen();
      break;
    case PreviewAction::close:
      is_done_ = true;
      break;
    default:
      break;
  }
}

/// About the pointer: the content below it stays there.
void LivePreview::zoom(double steps) {
  if (!view_.is_free() || check_.is_running()) {
    return;
  }
  const std::optional<Vec3> before = parts_.steering->pointer();
  view_.zoom(steps);
  show_view();
  if (before) {
    parts_.camera->bring(parts_.clock->now(), *before, *parts_.steering->pointer());
  }
  tell(view_.in_words());
}

}  // namespace foveola
