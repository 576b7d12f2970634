#include "renderer/gaze/open_gaze/open_gaze_records.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace foveola {
namespace {

constexpr std::string_view blanks = " \t\r";

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t') || code == 0x7f;
}

/// Letters, digits and underscores of ASCII, whatever the locale.
bool is_name_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// Removes `token` from the front of `text`, if it begins with it.
bool take(std::string_view token, std::string_view& text) {
  const bool is_there = text.starts_with(token);
  text.remove_prefix(is_there ? token.size() : 0);
  return is_there;
}

/// Removes blanks from the front; returns whether there were any.
bool take_blanks(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(count);
  return count > 0;
}

/// Removes a name from the front; empty if there is none.
std::string_view take_name(std::string_view& text) {
  const auto* const end = std::ranges::find_if_not(text, is_name_character);
  const std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(name.size());
  return name;
}

/// Removes ="VALUE" from the front.
std::optional<std::string_view> take_value(std::string_view& text) {
  if (!take("=\"", text)) {
    return std::nullopt;
  }
  const std::size_t end = text.find_first_of("\"<");
  if (end == std::string_view::npos || text[end] == '<') {
    return std::nullopt;
  }
  const std::string_view value = text.substr(0, end);
  text.remove_prefix(end + 1);
  return value;
}

OpenGazeKind kind_from(std::string_view name) {
  if (name == "REC") {
    return OpenGazeKind::record;
  }
  if (name == "ACK") {
    return OpenGazeKind::acknowledgement;
  }
  return name == "NACK" ? OpenGazeKind::refusal : OpenGazeKind::other;
}

const std::string* find(const OpenGazeElement& element, std::string_view key) {
  const auto found = element.attributes.find(key);
  return found == element.attributes.end() ? nullptr : &found->second;
}

/// The attribute as a decimal number in [minimum, maximum], whatever the locale.
template <typename Number>
std::optional<Number> number(const OpenGazeElement& element, std::string_view key, Number minimum,
                             Number maximum) {
  const std::string* text = find(element, key);
  if (text == nullptr) {
    return std::nullopt;
  }
  // Some programs write numbers in the computer's language.
  std::string decimal = *text;
  std::ranges::replace(decimal, ',', '.');
  Number value{};
  const char* const end = decimal.data() + decimal.size();
  const auto [stop, failure] = std::from_chars(decimal.data(), end, value);
  if (failure != std::errc() || stop != end || !(value >= minimum && value <= maximum)) {
    return std::nullopt;
  }
  return value;
}

/// The point of the eye whose attributes begin with `eye`; nullopt if the record lacks it.
std::optional<PointOfGaze> point_of(const OpenGazeElement& element, const std::string& eye) {
  constexpr double farthest = 100.0;
  const std::string* validity = find(element, eye + "POGV");
  if (validity == nullptr) {
    return std::nullopt;
  }
  const auto x = number(element, eye + "POGX", -farthest, farthest);
  const auto y = number(element, eye + "POGY", -farthest, farthest);
  if (*validity != "1" || !x || !y) {
    return PointOfGaze{.is_unreadable = *validity == "1"};
  }
  return PointOfGaze{.fraction = {*x, *y}, .valid = true};
}

}  // namespace

std::string open_gaze_requests() {
  std::string requests;
  for (const std::string_view what :
       {"COUNTER", "TIME", "POG_LEFT", "POG_RIGHT", "POG_BEST", "DATA"}) {
    requests += fmt::format("<SET ID=\"ENABLE_SEND_{}\" STATE=\"1\" />\r\n", what);
  }
  return requests;
}

std::optional<OpenGazeElement> parse_open_gaze(std::string_view line) {
  std::string_view rest = trimmed(line);
  if (std::ranges::any_of(rest, is_control) || !take("<", rest)) {
    return std::nullopt;
  }
  const std::string_view name = take_name(rest);
  if (name.empty()) {
    return std::nullopt;
  }
  OpenGazeElement element{.kind = kind_from(name)};
  for (;;) {
    const bool is_apart = take_blanks(rest);
    if (take("/>", rest)) {
      return rest.empty() ? std::optional(std::move(element)) : std::nullopt;
    }
    const std::string_view key = take_name(rest);
    const std::optional<std::string_view> value = take_value(rest);
    if (!is_apart || key.empty() || !value || !element.attributes.emplace(key, *value).second) {
      return std::nullopt;
    }
  }
}

std::vector<OpenGazeElement> OpenGazeStream::take(std::string_view bytes) {
  std::vector<OpenGazeElement> elements;
  for (;;) {
    const std::size_t end = bytes.find_first_of("\r\n");
    append(bytes.substr(0, end));
    if (end == std::string_view::npos) {
      return elements;
    }
    end_line(elements);
    bytes.remove_prefix(end + 1);
  }
}

void OpenGazeStream::append(std::string_view part) {
  is_too_long_ = is_too_long_ || part.size() > longest_line_bytes - line_.size();
  if (!is_too_long_) {
    line_.append(part);
  }
}

void OpenGazeStream::end_line(std::vector<OpenGazeElement>& elements) {
  std::optional<OpenGazeElement> element;
  if (!is_too_long_) {
    element = parse_open_gaze(line_);
  }
  if (element) {
    elements.push_back(std::move(*element));
  } else if (is_too_long_ || !trimmed(line_).empty()) {
    ++garbage_;
  }
  line_.clear();
  is_too_long_ = false;
}

OpenGazeRecord record_from(const OpenGazeElement& element) {
  using Whole = std::numeric_limits<std::int64_t>;
  return {.count = number(element, "CNT", std::int64_t{0}, Whole::max()),
          .time_s = number(element, "TIME", 0.0, 1e9),
          .best = point_of(element, "B"),
          .left = point_of(element, "L"),
          .right = point_of(element, "R")};
}

PointOfGaze combined_gaze(const OpenGazeRecord& record) {
  const PointOfGaze nowhere;
  if (!record.left && !record.right) {
    return record.best.value_or(nowhere);
  }
  const PointOfGaze left = record.left.value_or(nowhere);
  const PointOfGaze right = record.right.value_or(nowhere);
  if (left.valid && right.valid) {
    return {.fraction = 0.5 * (left.fraction + right.fraction), .valid = true};
  }
  return left.valid ? left : right;
}

}  // namespace foveola
