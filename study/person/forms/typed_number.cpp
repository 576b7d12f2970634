#include "study/person/forms/typed_number.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace foveola::study {
namespace {

constexpr std::string_view digits = "0123456789";

bool has_only_digits(std::string_view text) {
  return text.find_first_not_of(digits) == std::string_view::npos;
}

/// Whether `separator` splits the text into thousands: "12,345,678".
bool is_in_thousands(std::string_view text, char separator) {
  constexpr std::size_t group = 3;
  const std::size_t first = text.find(separator);
  if (first == 0 || first > group || text.front() == '0' ||
      !has_only_digits(text.substr(0, first))) {
    return false;
  }
  for (std::size_t i = first; i < text.size(); i += group + 1) {
    const std::string_view part = text.substr(i + 1, group);
    if (text[i] != separator || part.size() < group || !has_only_digits(part)) {
      return false;
    }
  }
  return true;
}

std::string without(std::string_view text, char separator) {
  std::string rest(text);
  std::erase(rest, separator);
  return rest;
}

std::optional<double> plain_number(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, number);
  return fault == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// A number with a decimal mark, and optionally the other mark between thousands.
std::optional<double> decimal_number(std::string_view text, char mark, char between_thousands) {
  const std::string_view whole = text.substr(0, text.find(mark));
  const std::string_view decimals = text.substr(whole.size() + 1);
  const bool is_whole = has_only_digits(whole) || is_in_thousands(whole, between_thousands);
  return is_whole && has_only_digits(decimals)
             ? plain_number(fmt::format("{}.{}", without(whole, between_thousands), decimals))
             : std::nullopt;
}

}  // namespace

std::vector<double> readings_of(std::string_view typed) {
  const bool is_negative = typed.starts_with('-');
  const std::string_view text = typed.substr(is_negative ? 1 : 0);
  std::vector<double> readings;
  const auto add = [&](const std::optional<double>& number) {
    if (number) {
      readings.push_back(is_negative ? -*number : *number);
    }
  };
  if (has_only_digits(text)) {
    add(plain_number(text));
  }
  for (const auto& [mark, other] : {std::pair('.', ','), std::pair(',', '.')}) {
    if (text.find(mark) == std::string_view::npos) {
      continue;
    }
    add(decimal_number(text, mark, other));
    if (is_in_thousands(text, mark)) {
      add(plain_number(without(text, mark)));
    }
  }
  return readings;
}

std::string unambiguous(double number, char decimal_mark) {
  std::string text = fmt::format("{}", number);
  std::replace(text.begin(), text.end(), '.', decimal_mark);
  return readings_of(text).size() > 1 ? text + '0' : text;
}

}  // namespace foveola::study
