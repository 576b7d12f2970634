#include "tests/openxr/runtime/times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "tests/openxr/runtime/calls.h"

namespace foveola::test::openxr {
namespace {

constexpr XrDuration ahead_of_system = nanoseconds(3600.0);

XrTime system_time(const timespec& time) {
  return static_cast<XrTime>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

XrTime now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return system_time(time) + ahead_of_system;
}

double script_time_s(const Session& session, XrTime time) {
  const std::vector<Frame>& frames = session.frames;
  if (frames.empty()) {
    return Frame().time_s;
  }
  const auto after =
      std::upper_bound(frames.begin(), frames.end(), time,
                       [](XrTime t, const Frame& frame) { return t < frame.display_time; });
  if (after == frames.begin()) {
    return frames.front().time_s;
  }
  const Frame& before = *std::prev(after);
  const auto since = static_cast<double>(time - before.display_time);
  if (after == frames.end()) {
    return before.time_s + since * 1e-9;
  }
  const auto whole = static_cast<double>(after->display_time - before.display_time);
  return std::lerp(before.time_s, after->time_s, since / whole);
}

XrTime time_of_script(const Session& session, double time_s) {
  const auto found = std::find_if(session.frames.begin(), session.frames.end(),
                                  [&](const Frame& frame) { return frame.time_s >= time_s; });
  return found == session.frames.end() ? now() : found->sample_time;
}

void require_time(const Session& session, XrTime time) {
  require(time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  const XrTime latest = session.frames.empty() ? now() : session.frames.back().display_time;
  const double distance_s = static_cast<double>(time - latest) * 1e-9;
  if (std::abs(distance_s) > 60.0) {
    throw Refusal(XR_ERROR_TIME_INVALID,
                  fmt::format("the time is {:.3f} s from the latest frame's, as another clock's "
                              "would be",
                              distance_s));
  }
}

XrResult convert_timespec_time_to_time(XrInstance instance, const timespec* timespec_time,
                                       XrTime* time) {
  instance_of(instance);
  XrTime& place = place_for(time, "the place for the time");
  const timespec& given = place_for(timespec_time, "the time");
  require(given.tv_sec >= 0 && given.tv_nsec >= 0 && given.tv_nsec < 1'000'000'000,
          XR_ERROR_TIME_INVALID, "the system's time is not one");
  place = system_time(given) + ahead_of_system;
  return XR_SUCCESS;
}

XrResult convert_time_to_timespec_time(XrInstance instance, XrTime time, timespec* timespec_time) {
  instance_of(instance);
  timespec& place = place_for(timespec_time, "the place for the time");
  require(time > ahead_of_system, XR_ERROR_TIME_INVALID,
          "the time is before the system's clock began");
  place.tv_sec = (time - ahead_of_system) / 1'000'000'000;
  place.tv_nsec = (time - ahead_of_system) % 1'000'000'000;
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
