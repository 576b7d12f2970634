#include "renderer/commands/gaze_filter_option.h"

#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/commands/arguments.h"

namespace foveola {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& remedy) {
  throw UsageError("--gaze-filter", what, remedy);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

double number_in(std::string_view text, const SettingRange& range, std::string_view what) {
  const std::optional<double> number = parse_finite_number(text);
  if (!number || *number < range.least || *number > range.most) {
    refuse(fmt::format("'{}' is not a {}", text, what),
           fmt::format("give a number from {} to {}", range.least, range.most));
  }
  return *number;
}

OneEuroSettings one_euro_in(std::string_view text) {
  const std::vector<std::string_view> numbers = split(text, ':');
  if (numbers.size() != 3) {
    refuse(fmt::format("'{}' is not a 1-Euro filter", text),
           "give one-euro=MIN_CUTOFF_HZ:BETA_PER_DEG:DERIVATIVE_CUTOFF_HZ, or one-euro alone");
  }
  return {
      .min_cutoff_hz = number_in(numbers[0], cutoff_range_hz, "cutoff frequency in hertz"),
      .beta_per_deg = number_in(numbers[1], beta_range_per_deg, "beta per degree"),
      .derivative_cutoff_hz = number_in(numbers[2], cutoff_range_hz, "cutoff frequency in hertz")};
}

/// The setting of the filter `name`, which must not be set yet.
template <typename Setting>
void add(std::string_view name, std::optional<Setting>& setting, const Setting& value) {
  if (setting) {
    refuse(fmt::format("'{}' is given twice", name), "remove one of them");
  }
  setting = value;
}

/// value: nullopt without one.
void add_filter(std::string_view name, const std::optional<std::string_view>& value,
                GazeFilterSettings& filter) {
  if (name == "one-euro") {
    add(name, filter.one_euro, value ? one_euro_in(*value) : OneEuroSettings{});
  } else if (name == "extrapolate") {
    if (!value) {
      refuse("'extrapolate' needs a time", "give extrapolate=0.03, in seconds");
    }
    add(name, filter.extrapolate_s,
        number_in(*value, horizon_range_s, "time in seconds to extrapolate by"));
  } else if (name == "hold") {
    add(name, filter.hold_s,
        value ? number_in(*value, hold_range_s, "time in seconds to hold a gaze for")
              : hold_range_s.most);
  } else {
    refuse(fmt::format("'{}' is not a gaze filter", name),
           fmt::format("give {}", gaze_filter_notation));
  }
}

}  // namespace

GazeFilterSettings parse_gaze_filter(const std::string& text) {
  GazeFilterSettings filter;
  if (text == "none") {
    return filter;
  }
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const bool has_value = equals != std::string_view::npos;
    add_filter(part.substr(0, equals),
               has_value ? std::optional(part.substr(equals + 1)) : std::nullopt, filter);
  }
  return filter;
}

}  // namespace foveola
