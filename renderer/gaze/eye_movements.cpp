#include "renderer/gaze/eye_movements.h"

#include <algorithm>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

/// Both movements as one of the first's kind.
EyeMovement joined(const EyeMovement& first, const EyeMovement& second) {
  return {.kind = first.kind,
          .start = first.start,
          .end = second.end,
          .from = first.from,
          .to = second.to,
          .fastest_deg_per_s = std::max(first.fastest_deg_per_s, second.fastest_deg_per_s)};
}

}  // namespace

std::vector<EyeMovement> EyeMovementDetector::push(const GazeSample& sample) {
  std::vector<EyeMovement> over;
  if (last_time_ && sample.time <= *last_time_) {
    return over;
  }
  last_time_ = sample.time;
  now_ = EyeMovementKind::no_data;
  if (last_valid_ && sample.time - last_valid_->time > settings_.longest_interval) {
    begin_no_data(over);
  }
  if (!sample.valid) {
    if (!going_on_ && !last_valid_) {
      going_on_ = EyeMovement{.start = sample.time, .end = sample.time};
    }
    return over;
  }
  if (last_valid_) {
    const EyeMovement step = step_to(sample);
    now_ = step.kind;
    add(step, over);
  } else if (going_on_) {
    going_on_->end = sample.time;
    over.push_back(*take_going_on());
  }
  last_valid_ = sample;
  return over;
}

std::optional<EyeMovement> EyeMovementDetector::finish() {
  if (going_on_ && going_on_->kind == EyeMovementKind::no_data) {
    going_on_->end = *last_time_;
  }
  const std::optional<EyeMovement> last = take_going_on();
  *this = EyeMovementDetector(settings_);
  return last;
}

void EyeMovementDetector::begin_no_data(std::vector<EyeMovement>& over) {
  if (const std::optional<EyeMovement> ended = take_going_on()) {
    over.push_back(*ended);
  }
  going_on_ = EyeMovement{.start = last_valid_->time, .end = last_valid_->time};
  last_valid_.reset();
}

void EyeMovementDetector::add(const EyeMovement& step, std::vector<EyeMovement>& over) {
  if (!going_on_) {
    going_on_ = step;
    return;
  }
  if (step.kind == going_on_->kind) {
    going_on_ = joined(*take_going_on(), step);
    return;
  }
  beginning_ = beginning_ ? joined(*beginning_, step) : step;
  if (beginning_->end - beginning_->start >= shortest(step.kind)) {
    over.push_back(*going_on_);
    going_on_ = beginning_;
    beginning_.reset();
  }
}

EyeMovement EyeMovementDetector::step_to(const GazeSample& sample) const {
  const double turn_deg = degrees(angle_between(last_valid_->direction, sample.direction));
  const double velocity_deg_per_s = turn_deg / seconds(sample.time - last_valid_->time);
  const bool is_fast = velocity_deg_per_s > settings_.threshold_deg_per_s;
  return {.kind = is_fast ? EyeMovementKind::saccade : EyeMovementKind::fixation,
          .start = last_valid_->time,
          .end = sample.time,
          .from = last_valid_->direction,
          .to = sample.direction,
          .fastest_deg_per_s = velocity_deg_per_s};
}

Nanoseconds EyeMovementDetector::shortest(EyeMovementKind kind) const {
  return kind == EyeMovementKind::saccade ? settings_.shortest_saccade
                                          : settings_.shortest_fixation;
}

std::optional<EyeMovement> EyeMovementDetector::take_going_on() {
  std::optional<EyeMovement> whole = going_on_;
  if (whole && beginning_) {
    whole = joined(*whole, *beginning_);
  }
  going_on_.reset();
  beginning_.reset();
  return whole;
}

}  // namespace foveola
