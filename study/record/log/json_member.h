// Reads JSON members that other versions may lack.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace foveola::study {

/// Returns the value of a JSON text; a discarded one (is_discarded()) if the text is not JSON or is
/// nested over 100 levels deep. Copying recurses once per level, hence the limit.
inline nlohmann::ordered_json parse_json(const std::string& text) {
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

/// Returns a copy of the member of this name; null if there is none or `json` is not an object.
inline nlohmann::ordered_json member_or_null(const nlohmann::ordered_json& json, const char* name) {
  return json.is_object() && json.contains(name) ? json.at(name) : nlohmann::ordered_json();
}

/// Returns whether it is an array of `count` numbers within the range of float.
inline bool has_numbers(const nlohmann::ordered_json& json, std::size_t count) {
  bool are_numbers = json.is_array() && json.size() == count;
  for (std::size_t i = 0; are_numbers && i < count; ++i) {
    are_numbers = json[i].is_number() &&
                  std::abs(json[i].get<double>()) <= double{std::numeric_limits<float>::max()};
  }
  return are_numbers;
}

}  // namespace foveola::study
