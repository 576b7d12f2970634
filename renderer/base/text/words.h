// Tables of words and their values, as files and command lines spell them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/transformed.h"

namespace foveola {

/// A text in a file and its value.
template <typename Value>
struct Word {
  std::string_view text;
  Value value;
};

template <typename Value, std::size_t count>
std::vector<std::string> texts_of(const std::array<Word<Value>, count>& words) {
  return transformed<std::string>(words, &Word<Value>::text);
}

/// The value of a checked text. Throws std::logic_error if `words` does not contain it.
template <typename Value, std::size_t count>
Value value_of(const std::array<Word<Value>, count>& words, std::string_view text) {
  const auto* const found = std::ranges::find(words, text, &Word<Value>::text);
  if (found == words.end()) {
    throw std::logic_error("nothing is called " + std::string(text));
  }
  return found->value;
}

/// The text of a value, which `words` must contain.
template <typename Value, std::size_t count>
const char* word_for(const std::array<Word<Value>, count>& words, Value value) {
  return std::ranges::find(words, value, &Word<Value>::value)->text.data();
}

}  // namespace foveola
