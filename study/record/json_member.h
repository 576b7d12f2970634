// Reads JSON of the record that another version may have written, or left out.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace foveola::study {

/// The value of a JSON text; what is no JSON, or nested more deeply than Foveola writes, becomes a
/// value that is neither an object nor anything else. Copying a value takes a call for each level.
inline nlohmann::ordered_json json_in(const std::string& text) {
  using Json = nlohmann::ordered_json;
  constexpr int max_depth = 100;
  constexpr bool may_throw = false;
  bool is_too_deep = false;
  Json json = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, const Json&) {
        is_too_deep = is_too_deep || depth > max_depth;
        return depth <= max_depth;
      },
      may_throw);
  return is_too_deep ? Json(Json::value_t::discarded) : json;
}

/// The member of this name; null if there is none, as in what is no object.
inline nlohmann::ordered_json member(const nlohmann::ordered_json& json, const char* name) {
  return json.is_object() && json.contains(name) ? json.at(name) : nlohmann::ordered_json();
}

/// Whether it is a list of so many numbers that a float holds.
inline bool has_numbers(const nlohmann::ordered_json& json, std::size_t count) {
  bool are_numbers = json.is_array() && json.size() == count;
  for (std::size_t i = 0; are_numbers && i < count; ++i) {
    are_numbers = json[i].is_number() &&
                  std::abs(json[i].get<double>()) <= double{std::numeric_limits<float>::max()};
  }
  return are_numbers;
}

}  // namespace foveola::study
