// Clocks: the machine's, and a virtual one that a test or a simulation advances.
#pragma once

#include <chrono>
#include <string>

namespace foveola {

/// Nanoseconds since an arbitrary but fixed origin of one run.
using Nanoseconds = std::chrono::nanoseconds;

inline double seconds(Nanoseconds duration) {
  return std::chrono::duration<double>(duration).count();
}
inline Nanoseconds nanoseconds_from_seconds(double duration_s) {
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(duration_s));
}

class Clock {
 public:
  virtual ~Clock() = default;
  virtual Nanoseconds now() const = 0;
};

/// The machine's monotonic clock.
class SteadyClock final : public Clock {
 public:
  Nanoseconds now() const override { return std::chrono::steady_clock::now().time_since_epoch(); }
};

/// Stands still between calls of advance().
class VirtualClock final : public Clock {
 public:
  Nanoseconds now() const override { return now_; }
  void advance(Nanoseconds duration) { now_ += duration; }

 private:
  Nanoseconds now_{0};
};

/// A time since 1970-01-01 as ISO 8601 in UTC with milliseconds: "2026-11-21T09:30:00.123Z".
std::string utc_text(Nanoseconds since_1970);

/// The wall clock's time, as utc_text.
std::string utc_now();

}  // namespace foveola
