// Reads JSON of the record that another version may have written, or left out.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace foveola::study {

/// The value of a JSON text; what is no JSON becomes a value that is neither an object nor anything
/// else.
inline nlohmann::ordered_json json_in(const std::string& text) {
  constexpr bool may_throw = false;
  return nlohmann::ordered_json::parse(text, nullptr, may_throw);
}

/// The member of this name; null if there is none, as in what is no object.
inline nlohmann::ordered_json member(const nlohmann::ordered_json& json, const char* name) {
  return json.is_object() && json.contains(name) ? json.at(name) : nlohmann::ordered_json();
}

/// Whether it is a list of so many numbers.
inline bool has_numbers(const nlohmann::ordered_json& json, std::size_t count) {
  bool are_numbers = json.is_array() && json.size() == count;
  for (std::size_t i = 0; are_numbers && i < count; ++i) {
    are_numbers = json[i].is_number();
  }
  return are_numbers;
}

}  // namespace foveola::study
