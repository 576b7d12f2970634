#include "study/record/clock_steps.h"

#include <cstdlib>
#include <ctime>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/progress.h"

namespace foveola::study {
namespace {

constexpr double minute_s = 60.0;
constexpr double day_s = 86400.0;
constexpr std::string_view clock_set_back_by = "the computer's clock was set back by ";

/// Since 1970. Empty if the text is no UTC time.
std::optional<double> seconds_of(const std::string& utc) {
  std::tm time{};
  const char* const fraction = ::strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%S", &time);
  if (fraction == nullptr) {
    return std::nullopt;
  }
  return static_cast<double>(::timegm(&time)) + std::strtod(fraction, nullptr);
}

}  // namespace

std::optional<std::string> clock_set_back(const std::string& before, const std::string& after) {
  const std::optional<double> before_s = seconds_of(before);
  const std::optional<double> after_s = seconds_of(after);
  if (!before_s || !after_s || *before_s - *after_s <= minute_s) {
    return std::nullopt;
  }
  const double back_s = *before_s - *after_s;
  return back_s < 2.0 * day_s ? human_duration(back_s) : fmt::format("{:.0f} days", back_s / day_s);
}

std::optional<std::string> note_of_clock(const std::vector<LoggedEvent>& events,
                                         const std::string& now) {
  if (events.empty()) {
    return std::nullopt;
  }
  const std::optional<std::string> back = clock_set_back(events.back().utc, now);
  return back ? std::optional(
                    fmt::format("{}{} since {}, when the session's last event was recorded",
                                clock_set_back_by, *back, events.back().utc))
              : std::nullopt;
}

bool is_note_of_clock(const std::string& note) { return note.starts_with(clock_set_back_by); }

}  // namespace foveola::study
