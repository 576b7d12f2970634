#include "renderer/gaze/simulated_eye.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/gaze/rotations.h"

namespace foveola {
namespace {

/// Dai et al. 2016.
constexpr double fastest_deg_s = 600.0;
constexpr double curvature_deg = 6.0;

/// Before its start and after its end by this time, a saccade is below double precision.
constexpr Nanoseconds fade = std::chrono::milliseconds(200);

constexpr Nanoseconds shortest_open = std::chrono::milliseconds(500);

/// t smoothed at its kink: 0 far below 0, t far above.
double smooth_ramp(double t) {
  return t < 0.0 ? 0.25 * std::exp(2.0 * t) : t + 0.25 * std::exp(-2.0 * t);
}

double between(double low, double high, Pcg32& random) {
  return low + (high - low) * random.uniform();
}

/// Gamma-distributed with an integer shape: a sum of exponential numbers.
double gamma(int shape, double mean, Pcg32& random) {
  double sum = 0.0;
  for (int i = 0; i < shape; ++i) {
    sum += random.exponential();
  }
  return mean * sum / shape;
}

double angle_between_deg(const DVec3& a, const DVec3& b) {
  return degrees(glm::length(rotation_between(a, b)));
}

/// `direction` after the part of the saccade done at `time`.
DVec3 moved(const DVec3& direction, const SimulatedSaccade& saccade, Nanoseconds time) {
  const Nanoseconds middle = saccade.start + (saccade.end - saccade.start) / 2;
  const double done_deg = saccade_progress_deg(saccade.amplitude_deg, seconds(time - middle));
  return rotated(direction,
                 rotation_between(saccade.from, saccade.to) * (done_deg / saccade.amplitude_deg));
}

template <typename Event>
std::vector<Event> started_before(const std::vector<Event>& events, Nanoseconds end) {
  const auto first_later = std::partition_point(
      events.begin(), events.end(), [&](const Event& event) { return event.start < end; });
  return {events.begin(), first_later};
}

}  // namespace

double saccade_duration_s(double amplitude_deg) { return 0.021 + 0.0022 * amplitude_deg; }

double saccade_progress_deg(double amplitude_deg, double since_middle_s) {
  // The formula's own time begins half an amplitude at full speed before the middle.
  const double t = fastest_deg_s * since_middle_s + 0.5 * amplitude_deg;
  return curvature_deg *
         (smooth_ramp(t / curvature_deg) - smooth_ramp((t - amplitude_deg) / curvature_deg));
}

SimulatedEye::SimulatedEye(const SimulatedEyeSettings& settings)
    : settings_(settings),
      saccade_random_(settings.seed, 0),
      microsaccade_random_(settings.seed, 1),
      blink_random_(settings.seed, 2) {
  assert(settings.shortest_fixation_s > 0.0);
  assert(settings.longest_fixation_s >= settings.shortest_fixation_s);
  // Makes the search for the next fixation short.
  assert(settings.smallest_saccade_deg > 0.0);
  assert(settings.spread_deg >= settings.smallest_saccade_deg);
  assert(settings.farthest_deg >= settings.spread_deg && settings.farthest_deg <= 90.0);
}

std::optional<Vec3> SimulatedEye::gaze(Nanoseconds time) {
  time = std::max(time, Nanoseconds::zero());
  plan_blinks(time);
  const auto blink = std::partition_point(blinks_.begin(), blinks_.end(),
                                          [&](const SimulatedBlink& b) { return b.end <= time; });
  if (blink != blinks_.end() && blink->start <= time) {
    return std::nullopt;
  }
  plan_saccades(time + fade);
  auto saccade =
      std::partition_point(saccades_.begin(), saccades_.end(),
                           [&](const SimulatedSaccade& s) { return s.end + fade <= time; });
  DVec3 direction = saccade->from;
  for (; saccade != saccades_.end() && saccade->start < time + fade; ++saccade) {
    direction = moved(direction, *saccade, time);
  }
  return Vec3(glm::normalize(direction));
}

std::vector<SimulatedSaccade> SimulatedEye::saccades(Nanoseconds end) {
  plan_saccades(end);
  return started_before(saccades_, end);
}

std::vector<SimulatedBlink> SimulatedEye::blinks(Nanoseconds end) {
  plan_blinks(end);
  return started_before(blinks_, end);
}

/// Plans until a saccade starts after `until`, or none ever does.
void SimulatedEye::plan_saccades(Nanoseconds until) {
  while (saccades_.empty() || saccades_.back().start <= until) {
    const double fixation_s =
        between(settings_.shortest_fixation_s, settings_.longest_fixation_s, saccade_random_);
    const Nanoseconds fixation_end = still_since_ + nanoseconds_from_seconds(fixation_s);
    plan_microsaccades(fixation_end);
    fixation_ = next_fixation();
    add_saccade(fixation_end, fixation_, false);
  }
}

void SimulatedEye::plan_microsaccades(Nanoseconds fixation_end) {
  constexpr int interval_shape = 5;
  constexpr int amplitude_shape = 4;
  if (settings_.microsaccade_interval_s <= 0.0) {
    return;
  }
  while (next_microsaccade_ < fixation_end) {
    const double amplitude_deg =
        gamma(amplitude_shape, settings_.microsaccade_amplitude_deg, microsaccade_random_);
    const Nanoseconds end =
        next_microsaccade_ + nanoseconds_from_seconds(saccade_duration_s(amplitude_deg));
    // Microsaccades that would overlap another saccade, or begin at time 0, are left out.
    if (next_microsaccade_ > still_since_ && end < fixation_end) {
      add_saccade(next_microsaccade_, next_microsaccade_target(amplitude_deg), true);
    }
    const double interval_s =
        gamma(interval_shape, settings_.microsaccade_interval_s, microsaccade_random_);
    next_microsaccade_ += nanoseconds_from_seconds(interval_s);
  }
}

void SimulatedEye::plan_blinks(Nanoseconds until) {
  if (settings_.blinks_per_minute <= 0.0) {
    return;
  }
  const double mean_blink_s = 0.5 * (settings_.shortest_blink_s + settings_.longest_blink_s);
  const double spare_s = 60.0 / settings_.blinks_per_minute - mean_blink_s - seconds(shortest_open);
  assert(spare_s >= 0.0);
  while (blinks_.empty() || blinks_.back().start <= until) {
    const Nanoseconds open_since = blinks_.empty() ? Nanoseconds::zero() : blinks_.back().end;
    const double more_s = spare_s * blink_random_.exponential();
    const double blink_s =
        between(settings_.shortest_blink_s, settings_.longest_blink_s, blink_random_);
    const Nanoseconds start = open_since + shortest_open + nanoseconds_from_seconds(more_s);
    blinks_.push_back({.start = start, .end = start + nanoseconds_from_seconds(blink_s)});
  }
}

void SimulatedEye::add_saccade(Nanoseconds start, const DVec3& target, bool is_micro) {
  const double amplitude_deg = angle_between_deg(direction_, target);
  const Nanoseconds end = start + nanoseconds_from_seconds(saccade_duration_s(amplitude_deg));
  saccades_.push_back({.start = start,
                       .end = end,
                       .from = direction_,
                       .to = target,
                       .amplitude_deg = amplitude_deg,
                       .is_micro = is_micro});
  direction_ = target;
  still_since_ = end;
}

DVec3 SimulatedEye::next_fixation() {
  const DVec3 ahead(0.0, 0.0, -1.0);
  for (;;) {
    const double right_deg = settings_.spread_deg * saccade_random_.normal();
    const double up_deg = settings_.spread_deg * saccade_random_.normal();
    const DVec3 target = glm::normalize(DVec3(
        direction_from({.azimuth_rad = radians(right_deg), .elevation_rad = radians(up_deg)})));
    const double amplitude_deg = angle_between_deg(direction_, target);
    if (angle_between_deg(ahead, target) <= settings_.farthest_deg &&
        amplitude_deg >= settings_.smallest_saccade_deg && amplitude_deg < settings_.farthest_deg) {
      return target;
    }
  }
}

/// From the fixation in any direction, otherwise roughly back to it, so that microsaccades do not
/// drift away in the long run (assumed).
DVec3 SimulatedEye::next_microsaccade_target(double amplitude_deg) {
  const DVec3 back = rotation_between(direction_, fixation_);
  const bool is_away = glm::length(back) > 1e-9;
  const double largest_turn = is_away ? 0.25 * std::numbers::pi : std::numbers::pi;
  const double turn = between(-largest_turn, largest_turn, microsaccade_random_);
  const DVec3 axis =
      is_away ? glm::normalize(back)
              : glm::normalize(glm::cross(direction_, DVec3(Frame(Vec3(direction_)).tangent)));
  return glm::normalize(
      rotated(direction_, rotated(axis, direction_ * turn) * radians(amplitude_deg)));
}

}  // namespace foveola
