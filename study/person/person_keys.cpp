#include "study/person/person_keys.h"

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

std::optional<PersonKey> meaning_of(const CharacterTyped& typed) {
  switch (typed.character) {
    case U'y':
    case U'Y':
      return PersonKey::yes;
    case U'n':
    case U'N':
      return PersonKey::no;
    case U'r':
    case U'R':
      return PersonKey::again;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<PersonKey> person_key(const WindowEvent& event) {
  if (const auto* key = std::get_if<KeyMoved>(&event.what)) {
    return meaning_of(*key);
  }
  if (const auto* typed = std::get_if<CharacterTyped>(&event.what)) {
    return meaning_of(*typed);
  }
  return std::holds_alternative<CloseWanted>(event.what) ? std::optional(PersonKey::pause)
                                                         : std::nullopt;
}

WindowEvent press_of(PersonKey key, Nanoseconds time) {
  const auto down = [&](int place) {
    return WindowEvent{.time = time, .what = KeyMoved{.key = place, .is_down = true}};
  };
  const auto typed = [&](char32_t character) {
    return WindowEvent{.time = time, .what = CharacterTyped{character}};
  };
  switch (key) {
    case PersonKey::mark:
      return down(GLFW_KEY_SPACE);
    case PersonKey::confirm:
      return down(GLFW_KEY_ENTER);
    case PersonKey::next:
      return down(GLFW_KEY_TAB);
    case PersonKey::back:
      return down(GLFW_KEY_BACKSPACE);
    case PersonKey::pause:
      return down(GLFW_KEY_ESCAPE);
    case PersonKey::yes:
      return typed(U'y');
    case PersonKey::no:
      return typed(U'n');
    case PersonKey::again:
      break;
  }
  return typed(U'r');
}

}  // namespace foveola::study
