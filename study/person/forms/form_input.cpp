#include "study/person/forms/form_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola::study {
namespace {

std::optional<FormKey> form_key(int key) {
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return FormKey::enter;
    case GLFW_KEY_TAB:
      return FormKey::tab;
    case GLFW_KEY_LEFT:
      return FormKey::left;
    case GLFW_KEY_RIGHT:
      return FormKey::right;
    case GLFW_KEY_UP:
      return FormKey::up;
    case GLFW_KEY_DOWN:
      return FormKey::down;
    case GLFW_KEY_BACKSPACE:
      return FormKey::erase;
    default:
      return std::nullopt;
  }
}

int place_of(FormKey key) {
  switch (key) {
    case FormKey::enter:
      return GLFW_KEY_ENTER;
    case FormKey::tab:
      return GLFW_KEY_TAB;
    case FormKey::left:
      return GLFW_KEY_LEFT;
    case FormKey::right:
      return GLFW_KEY_RIGHT;
    case FormKey::up:
      return GLFW_KEY_UP;
    case FormKey::down:
      return GLFW_KEY_DOWN;
    case FormKey::step:
      return GLFW_KEY_SPACE;
    case FormKey::erase:
      break;
  }
  return GLFW_KEY_BACKSPACE;
}

}  // namespace

std::optional<FormInput> form_input(const WindowEvent& event) {
  if (const auto* typed = std::get_if<CharacterTyped>(&event.what)) {
    return typed->character;
  }
  if (const auto* moved = std::get_if<KeyMoved>(&event.what); moved != nullptr && moved->is_down) {
    return form_key(moved->key);
  }
  return std::nullopt;
}

WindowEvent make_press(const FormInput& input, Nanoseconds time) {
  if (const auto* typed = std::get_if<char32_t>(&input)) {
    return {.time = time, .what = CharacterTyped{*typed}};
  }
  return {.time = time,
          .what = KeyMoved{.key = place_of(std::get<FormKey>(input)), .is_down = true}};
}

}  // namespace foveola::study
