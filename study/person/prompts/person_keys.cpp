#include "study/person/prompts/person_keys.h"

#include <array>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace foveola::study {
namespace {

std::optional<PersonKey> meaning_of(const KeyMoved& key) {
  if (!key.is_down) {
    return std::nullopt;
  }
  switch (key.key) {
    case GLFW_KEY_SPACE:
      return PersonKey::mark;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return PersonKey::confirm;
    case GLFW_KEY_TAB:
      return PersonKey::next;
    case GLFW_KEY_BACKSPACE:
      return PersonKey::back;
    case GLFW_KEY_ESCAPE:
      return PersonKey::pause;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<PersonKey> person_key(const WindowEvent& event) {
  if (const auto* key = std::get_if<KeyMoved>(&event.what)) {
    return meaning_of(*key);
  }
  return std::holds_alternative<CloseWanted>(event.what) ? std::optional(PersonKey::pause)
                                                         : std::nullopt;
}

WindowEvent make_press(PersonKey key, Nanoseconds time) {
  constexpr std::array places = {GLFW_KEY_SPACE, GLFW_KEY_ENTER, GLFW_KEY_TAB, GLFW_KEY_BACKSPACE,
                                 GLFW_KEY_ESCAPE};
  const int place = places.at(static_cast<std::size_t>(key));
  return {.time = time, .what = KeyMoved{.key = place, .is_down = true}};
}

}  // namespace foveola::study
