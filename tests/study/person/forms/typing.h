// Hands that fill in forms.
#pragma once

#include <string_view>

#include "study/person/forms/form.h"

namespace foveola::study::test {

/// Types each letter. Returns whether all were taken.
template <typename Typewriter>
bool type(Typewriter& into, std::u32string_view letters) {
  bool is_taken = true;
  for (const char32_t letter : letters) {
    is_taken = into.follow(letter) && is_taken;
  }
  return is_taken;
}

template <typename Typewriter>
bool press(Typewriter& on, std::initializer_list<FormKey> keys) {
  bool is_taken = true;
  for (const FormKey key : keys) {
    is_taken = on.follow(key) && is_taken;
  }
  return is_taken;
}

inline Question age() {
  return {.id = "age",
          .text = "How old are you?",
          .kind = QuestionKind::number,
          .minimum = 18,
          .maximum = 99};
}

inline Question gender() {
  return {
      .id = "gender",
      .text = "What is your gender?",
      .kind = QuestionKind::choice,
      .options = {
          {.label = "female", .value = 5.0}, {.label = "male", .value = 1.0}, {.label = "other"}}};
}

inline Question experience() {
  return {.id = "experience", .text = "How experienced are you?", .labels = {"not at all", "very"}};
}

inline Question comments() {
  return {
      .id = "comments", .text = "Anything else?", .kind = QuestionKind::text, .required = false};
}

}  // namespace foveola::study::test
