#include "study/record/write/clock_steps.h"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/work/work_scope.h"

namespace foveola::study {
namespace {

constexpr double minute_s = 60.0;
constexpr double day_s = 86400.0;
constexpr std::string_view clock_set_back_by = "the computer's clock was set back by ";
constexpr std::string_view clock_set_forward_by = "the computer's clock was set forward by ";
constexpr std::string_view computer_slept_for = "the computer slept for ";
constexpr std::string_view while_session_ran = " while the session ran";

/// "3 m 05 s", "2 h 10 m" or "3653 days".
std::string words_for_step(double step_s) {
  return step_s < 2.0 * day_s ? human_duration(step_s) : fmt::format("{:.0f} days", step_s / day_s);
}

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
  return words_for_step(*before_s - *after_s);
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

std::string note_of_clock_step(Nanoseconds step) {
  return fmt::format("{}{}{}", step < Nanoseconds(0) ? clock_set_back_by : clock_set_forward_by,
                     words_for_step(std::abs(seconds(step))), while_session_ran);
}

std::string note_of_sleep(Nanoseconds duration) {
  return fmt::format("{}{}{}", computer_slept_for, words_for_step(seconds(duration)),
                     while_session_ran);
}

bool is_note_of_running_session(const std::string& note) {
  return note.ends_with(while_session_ran) &&
         (note.starts_with(clock_set_back_by) || note.starts_with(clock_set_forward_by) ||
          note.starts_with(computer_slept_for));
}

bool is_note_of_clock(const std::string& note) {
  return note.starts_with(clock_set_back_by) || is_note_of_running_session(note);
}

}  // namespace foveola::study
