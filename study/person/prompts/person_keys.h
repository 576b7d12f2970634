// The keys of a participant: few and large, the same everywhere.
#pragma once

#include <optional>

#include "renderer/window/window_event.h"

namespace foveola::study {

enum class PersonKey {
  mark,     ///< Space: also starts a trial, and answers what appears
  confirm,  ///< Enter: also goes on
  next,     ///< Tab
  back,     ///< Backspace
  pause,    ///< Escape, or the window's cross
};

/// What an event means, if it is a key that goes down: by its place, the same on every layout.
std::optional<PersonKey> person_key(const WindowEvent& event);

/// An event that means this.
WindowEvent press_of(PersonKey key, Nanoseconds time);

}  // namespace foveola::study
