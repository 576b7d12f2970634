// The participant's keys: few and large, the same in every phase.
#pragma once

#include <optional>

#include "renderer/window/window_event.h"

namespace foveola::study {

enum class PersonKey {
  mark,     ///< Space: marks, starts a trial, answers the reaction test
  confirm,  ///< Enter: confirms, continues
  next,     ///< Tab
  back,     ///< Backspace
  pause,    ///< Escape, or the window's cross
};

/// Returns the key of a press, by its place on the keyboard, whatever the layout; else empty.
std::optional<PersonKey> person_key(const WindowEvent& event);

/// Returns an event that stands for `key`.
WindowEvent make_press(PersonKey key, Nanoseconds time);

}  // namespace foveola::study
