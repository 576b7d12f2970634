#include "renderer/window/window_event.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola {
namespace {

bool wants_to_leave(const WindowEvent& event) {
  const auto* const key = std::get_if<KeyMoved>(&event.what);
  return std::holds_alternative<CloseWanted>(event.what) ||
         (key != nullptr && key->is_down && key->key == GLFW_KEY_ESCAPE);
}

}  // namespace

const char* words_for(HeadsetChange change) {
  switch (change) {
    case HeadsetChange::recentred:
      return "the headset was recentred";
    case HeadsetChange::lost_focus:
      return "the headset shows something else";
    case HeadsetChange::got_focus:
      return "the headset shows this";
    case HeadsetChange::taken_off:
      return "the headset was taken off";
    case HeadsetChange::put_on:
      return "the headset was put on";
    case HeadsetChange::lost:
      return "the headset was lost";
    case HeadsetChange::found:
      return "the headset was found again";
    case HeadsetChange::exit_wanted:
      break;
  }
  return "the headset's runtime ended this";
}

void WindowEvents::push(WindowEvent event) {
  if (wants_to_leave(event)) {
    closing_.request_stop();
  }
  const std::scoped_lock lock(mutex_);
  events_.push_back(std::move(event));
}

std::vector<WindowEvent> WindowEvents::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(events_, {});
}

}  // namespace foveola
