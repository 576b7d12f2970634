#include "analysis/tables/number_text.h"

#include <cmath>

#include <fmt/format.h>

namespace foveola::analysis {
namespace {

bool is_zero(const std::string& text) {
  return text.find_first_of("123456789") == std::string::npos;
}

}  // namespace

std::string fixed(std::optional<double> value, int decimals) {
  if (!value) {
    return no_value;
  }
  const std::string text = fmt::format("{:.{}f}", *value, decimals);
  const bool is_negative_zero = is_zero(text) && std::isfinite(*value) && text.front() == '-';
  return is_negative_zero ? text.substr(1) : text;
}

std::string with_sign(std::optional<double> value, int decimals) {
  const std::string text = fixed(value, decimals);
  return value && *value > 0.0 && !is_zero(text) ? "+" + text : text;
}

std::string p_value(double p) {
  constexpr double smallest_printed = 1e-300;
  return p < smallest_printed ? "< 1e-300" : fmt::format("{:#.2g}", p);
}

}  // namespace foveola::analysis
