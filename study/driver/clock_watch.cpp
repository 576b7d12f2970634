#include "study/driver/clock_watch.h"

#include <chrono>
#include <ctime>

#include "study/driver/session_driver.h"
#include "study/record/write/clock_steps.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds max_unnoted_step = 5s;
/// Shorter than any sleep of a computer, and longer than the interval of any two readings.
constexpr Nanoseconds max_unnoted_sleep = 100ms;
constexpr Nanoseconds max_reading_time = 1ms;

Nanoseconds time_by(clockid_t clock) {
  std::timespec time{};
  ::clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

}  // namespace

ClockReadings read_clocks() {
  while (true) {
    const ClockReadings readings{.steady = time_by(CLOCK_MONOTONIC),
                                 .since_boot = time_by(CLOCK_BOOTTIME),
                                 .since_1970 = time_by(CLOCK_REALTIME)};
    // A thread that is delayed between two readings would look like a step of a clock.
    if (time_by(CLOCK_MONOTONIC) - readings.steady < max_reading_time) {
      return readings;
    }
  }
}

std::vector<std::string> ClockWatch::notes_until(const ClockReadings& now) {
  std::vector<std::string> notes;
  const Nanoseconds awake = now.steady - start_.steady;
  const Nanoseconds asleep = now.since_boot - start_.since_boot - awake;
  if (asleep > max_unnoted_sleep) {
    notes.push_back(note_of_sleep(asleep));
    start_.since_boot += asleep;
    start_.since_1970 += asleep;
  }
  const Nanoseconds step = now.since_1970 - start_.since_1970 - awake;
  if (step > max_unnoted_step || step < -max_unnoted_step) {
    notes.push_back(note_of_clock_step(step));
    start_.since_1970 += step;
  }
  return notes;
}

void follow_clocks(ClockWatch& watch, const ClockReadings& now, SessionDriver& driver) {
  const std::vector<std::string> notes = watch.notes_until(now);
  for (const std::string& note : notes) {
    driver.record_event(NoteWritten{note});
  }
  if (!notes.empty()) {
    driver.record_event(RetimeRequested{});
  }
}

}  // namespace foveola::study
