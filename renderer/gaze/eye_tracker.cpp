#include "renderer/gaze/eye_tracker.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

/// Turns `direction` by two independent normal angles, across and up.
Vec3 with_noise(const Vec3& direction, double precision_deg, Pcg32& noise) {
  const Frame frame(direction);
  const double across = std::tan(radians(precision_deg * noise.normal()));
  const double up = std::tan(radians(precision_deg * noise.normal()));
  return glm::normalize(direction + static_cast<float>(across) * frame.tangent +
                        static_cast<float>(up) * frame.bitangent);
}

Vec3 with_bias(const Vec3& direction, double right_deg, double up_deg) {
  if (right_deg == 0.0 && up_deg == 0.0) {
    return direction;  // bit for bit
  }
  const AzimuthElevation angles = azimuth_elevation(direction);
  return direction_from({.azimuth_rad = angles.azimuth_rad + radians(right_deg),
                         .elevation_rad = angles.elevation_rad + radians(up_deg)});
}

constexpr Nanoseconds interval = std::chrono::milliseconds(8);
/// After so long a pause between polls, older samples are of no interest.
constexpr Nanoseconds longest_gap = std::chrono::seconds(5);

}  // namespace

void FixedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  arrived.push_back({.time = now, .direction = direction_, .valid = true});
}

SimulatedEyeTracker::SimulatedEyeTracker(const SimulatedTrackerSettings& settings,
                                         TrueGaze true_gaze)
    : settings_(settings), true_gaze_(std::move(true_gaze)) {
  assert(settings_.rate_hz > 0.0);
}

void SimulatedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::int64_t last = last_exposure(now - nanoseconds_from_seconds(settings_.latency_s));
  std::int64_t index = next_.value_or(std::max(last, std::int64_t{0}));
  for (; index <= last; ++index) {
    arrived.push_back(expose(index));
  }
  next_ = index;
}

Nanoseconds SimulatedEyeTracker::exposure_time(std::int64_t index) const {
  return Nanoseconds(std::llround(1e9 * static_cast<double>(index) / settings_.rate_hz));
}

std::int64_t SimulatedEyeTracker::last_exposure(Nanoseconds time) const {
  const auto index = static_cast<std::int64_t>(std::floor(seconds(time) * settings_.rate_hz));
  // The product may round across an exposure.
  if (exposure_time(index + 1) <= time) {
    return index + 1;
  }
  return exposure_time(index) > time ? index - 1 : index;
}

GazeSample SimulatedEyeTracker::expose(std::int64_t index) const {
  const Nanoseconds time = exposure_time(index);
  const std::optional<Vec3> eye = true_gaze_(time);
  if (!eye) {
    return {.time = time};
  }
  // Keyed by the sample's index: polls do not change the tracker's samples.
  Pcg32 noise(settings_.seed, static_cast<std::uint64_t>(index));
  const Vec3 biased = with_bias(*eye, settings_.bias_right_deg, settings_.bias_up_deg);
  const Vec3 seen = with_noise(biased, settings_.precision_deg, noise);
  if (noise.uniform() < settings_.data_loss) {
    return {.time = time};
  }
  return {.time = time, .direction = seen, .valid = true};
}

Vec3 direction_at(const Screen& screen, const DVec2& fraction) {
  const double right = std::tan(radians(0.5 * screen.horizontal_fov_deg));
  const double up = std::tan(radians(0.5 * screen.vertical_fov_deg));
  return Vec3(
      glm::normalize(DVec3((2.0 * fraction.x - 1.0) * right, (1.0 - 2.0 * fraction.y) * up, -1.0)));
}

DVec2 fraction_of(const Screen& screen, const DVec2& metres) {
  return {metres.x / screen.width_m, metres.y / screen.height_m};
}

void PointerEyeTracker::point_at(Nanoseconds time, const std::optional<Vec3>& direction) {
  GazeSample event{.time = time, .valid = direction.has_value()};
  event.direction = direction.value_or(event.direction);
  const std::lock_guard lock(mutex_);
  events_.push_back(event);
  const auto is_recent = [&](const GazeSample& e) { return time - e.time <= longest_gap; };
  const auto recent = std::find_if(events_.cbegin(), events_.cend(), is_recent);
  if (recent != events_.cbegin()) {
    events_.erase(events_.cbegin(), std::prev(recent));  // keeps the position before
  }
}

void PointerEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::lock_guard lock(mutex_);
  if (events_.empty()) {
    return;
  }
  // An event may come between `now` and this call.
  const Nanoseconds newest = std::max(events_.back().time, now);
  const Nanoseconds gap = newest - last_sample_.value_or(newest);
  const auto samples =
      gap > longest_gap ? 1 : std::max<std::int64_t>(1, (gap + interval / 2) / interval);
  auto event = events_.cbegin();
  for (std::int64_t left = samples - 1; left >= 0; --left) {
    const Nanoseconds time = newest - left * gap / samples;
    while (std::next(event) != events_.cend() && std::next(event)->time <= time) {
      ++event;
    }
    if (event->time <= time) {
      arrived.push_back(*event);
      arrived.back().time = time;
    }
  }
  events_.erase(events_.cbegin(), std::prev(events_.cend()));
  last_sample_ = newest;
}

}  // namespace foveola
