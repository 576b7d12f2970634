// Maps window events to the inputs of a form.
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
  step  ///< the next option, cyclically: for controllers with a single button to choose with
};

/// A key, or a typed character.
using FormInput = std::variant<FormKey, char32_t>;

/// Returns the event's input; empty if it means nothing to a form, such as a key release.
std::optional<FormInput> form_input(const WindowEvent& event);

/// Returns an event that stands for `input`.
WindowEvent make_press(const FormInput& input, Nanoseconds time);

}  // namespace foveola::study
