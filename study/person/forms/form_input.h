// What a form understands of a keyboard.
#pragma once

#include <optional>
#include <variant>

#include "renderer/window/window_event.h"

namespace foveola::study {

enum class FormKey {
  enter,
  tab,
  left,
  right,
  up,
  down,
  erase,
  step  ///< the next one, and after the last one the first: for who has a single button to choose
};

/// A key, or what was typed.
using FormInput = std::variant<FormKey, char32_t>;

/// Empty for events that mean nothing to a form, such as keys that are let go.
std::optional<FormInput> form_input(const WindowEvent& event);

/// An event that means this.
WindowEvent press_of(const FormInput& input, Nanoseconds time);

}  // namespace foveola::study
