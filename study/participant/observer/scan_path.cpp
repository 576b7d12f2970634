#include "study/participant/observer/scan_path.h"

#include <algorithm>
#include <numbers>

#include "study/participant/chance.h"

namespace foveola::study {
namespace {

/// Returns 0 before `start`, 1 after `end`, and a smooth transition between.
double eased(Nanoseconds time, Nanoseconds start, Nanoseconds end) {
  if (time >= end) {
    return 1.0;
  }
  const double t = std::max(0.0, seconds(time - start) / seconds(end - start));
  return t * t * (3.0 - 2.0 * t);
}

/// Returns the last item of a path that has begun by `time`; the first if none has.
template <typename Items>
std::size_t current(const Items& items, Nanoseconds time) {
  std::size_t i = items.size() - 1;
  while (i > 0 && items[i].start > time) {
    --i;
  }
  return i;
}

double between(double low, double high, Pcg32& random) {
  return low + (high - low) * random.uniform();
}

/// Returns the shorter turn from one heading to another.
AzimuthElevation turn_between(const AzimuthElevation& from, const AzimuthElevation& to) {
  return {.azimuth_rad = std::remainder(to.azimuth_rad - from.azimuth_rad, 2.0 * std::numbers::pi),
          .elevation_rad = to.elevation_rad - from.elevation_rad};
}

AzimuthElevation turned(const AzimuthElevation& from, const AzimuthElevation& turn, double part) {
  return {.azimuth_rad = from.azimuth_rad + part * turn.azimuth_rad,
          .elevation_rad = from.elevation_rad + part * turn.elevation_rad};
}

}  // namespace

ScanPath::ScanPath(const GazeHabits& habits, std::uint64_t seed)
    : habits_(habits), random_(chance(seed, Chance::path)), saccades_(1), turns_(1) {}

void ScanPath::fixate(const Vec3& target, Nanoseconds start) {
  begin(start);
  exploring_ = false;
  radius_deg_ = 0.0;
  add_saccade(target, start + nanoseconds_from_seconds(habits_.saccade_latency_s));
}

void ScanPath::examine(const Vec3& object, double radius_deg, Nanoseconds start) {
  begin(start);
  exploring_ = false;
  object_ = object;
  radius_deg_ = radius_deg;
  turn_head(azimuth_elevation(object), start);
}

void ScanPath::explore(double azimuth_rad, Nanoseconds start) {
  begin(start);
  exploring_ = true;
  around_azimuth_rad_ = azimuth_rad;
  fixations_since_turn_ = fixations_per_turn();
}

void ScanPath::begin(Nanoseconds start) {
  const Saccade none{.start = start, .end = start, .target = gaze(start)};
  const HeadTurn turn{.start = start, .end = start, .heading = head(start)};
  saccades_.assign(1, none);
  turns_.assign(1, turn);
  next_saccade_ = start;
}

void ScanPath::turn_head(const AzimuthElevation& heading, Nanoseconds start) {
  const double angle_deg =
      degrees(angle_between(direction_from(turns_.back().heading), direction_from(heading)));
  const Nanoseconds end = start + nanoseconds_from_seconds(habits_.head_turn_s +
                                                           habits_.head_turn_s_per_deg * angle_deg);
  turns_.push_back({.start = start, .end = end, .heading = heading});
}

Vec3 ScanPath::gaze(Nanoseconds time) {
  continue_to(time);
  const std::size_t i = current(saccades_, time);
  const Saccade& to = saccades_[i];
  if (time >= to.end) {
    return to.target;
  }
  const Saccade& from = saccades_[i > 0 ? i - 1 : 0];
  const double part = eased(time, to.start, to.end);
  if (to.turn == 0) {
    return glm::normalize(glm::mix(from.target, to.target, static_cast<float>(part)));
  }
  // From one place in the head to another, for any turn of the head.
  const AzimuthElevation before =
      turn_between(turns_[to.turn - 1].heading, azimuth_elevation(from.target));
  const AzimuthElevation after =
      turn_between(turns_[to.turn].heading, azimuth_elevation(to.target));
  const AzimuthElevation in_head = turned(before, turn_between(before, after), part);
  return direction_from(turned(head(time), in_head, 1.0));
}

ScanPath::Fixation ScanPath::fixation(Nanoseconds time) {
  continue_to(time);
  const std::size_t i = current(saccades_, time);
  const Saccade& saccade = saccades_[i];
  Nanoseconds end = wanders() ? next_saccade_ : Nanoseconds::max();
  if (i + 1 < saccades_.size()) {
    end = saccades_[i + 1].start;
  }
  return {.begin = saccade.start, .landing = saccade.end, .end = end, .direction = saccade.target};
}

AzimuthElevation ScanPath::head(Nanoseconds time) {
  continue_to(time);
  const std::size_t i = current(turns_, time);
  const HeadTurn& to = turns_[i];
  const HeadTurn& from = turns_[i > 0 ? i - 1 : 0];
  return turned(from.heading, turn_between(from.heading, to.heading),
                eased(time, to.start, to.end));
}

void ScanPath::continue_to(Nanoseconds time) {
  while (wanders() && next_saccade_ <= time) {
    const Nanoseconds landing = add_saccade(next_target(), next_saccade_);
    next_saccade_ =
        landing + nanoseconds_from_seconds(
                      between(habits_.shortest_fixation_s, habits_.longest_fixation_s, random_));
  }
}

Nanoseconds ScanPath::add_saccade(const Vec3& target, Nanoseconds start) {
  const double amplitude_deg = degrees(angle_between(saccades_.back().target, target));
  const Nanoseconds end =
      start +
      nanoseconds_from_seconds(habits_.saccade_s + habits_.saccade_s_per_deg * amplitude_deg);
  const std::size_t turn = turns_.back().start == start ? turns_.size() - 1 : 0;
  const Nanoseconds landing = turn > 0 ? std::max(end, turns_.back().end) : end;
  saccades_.push_back({.start = start, .end = landing, .target = target, .turn = turn});
  return landing;
}

Vec3 ScanPath::next_target() { return exploring_ ? target_around() : target_on_object(); }

Vec3 ScanPath::target_on_object() {
  const double radius_rad =
      radians(radius_deg_ * habits_.examined_part * std::sqrt(random_.uniform()));
  const double angle_rad = 2.0 * std::numbers::pi * random_.uniform();
  const Frame frame(object_);
  return frame.to_world({static_cast<float>(std::sin(radius_rad) * std::cos(angle_rad)),
                         static_cast<float>(std::sin(radius_rad) * std::sin(angle_rad)),
                         static_cast<float>(std::cos(radius_rad))});
}

Vec3 ScanPath::target_around() {
  if (fixations_since_turn_ == fixations_per_turn()) {
    fixations_since_turn_ = 0;
    const double right_deg = between(-habits_.head_azimuth_deg, habits_.head_azimuth_deg, random_);
    const double up_deg = between(-habits_.head_elevation_deg, habits_.head_elevation_deg, random_);
    turn_head(
        {.azimuth_rad = around_azimuth_rad_ + radians(right_deg), .elevation_rad = radians(up_deg)},
        next_saccade_);
  }
  ++fixations_since_turn_;
  const AzimuthElevation& heading = turns_.back().heading;
  const double eye_right_deg = habits_.eye_in_head_deg * random_.normal();
  const double eye_up_deg = habits_.eye_in_head_deg * random_.normal();
  return direction_from({.azimuth_rad = heading.azimuth_rad + radians(eye_right_deg),
                         .elevation_rad = heading.elevation_rad + radians(eye_up_deg)});
}

}  // namespace foveola::study
