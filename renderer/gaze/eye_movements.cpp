#include "renderer/gaze/eye_movements.h"

#include <algorithm>

#include "renderer/base/angles.h"
#include "renderer/gaze/gaze_filter.h"

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

GazeMark mark_of(const EyeMovement& movement) {
  switch (movement.kind) {
    case EyeMovementKind::fixation:
      return GazeMark::fixation;
    case EyeMovementKind::saccade:
      return GazeMark::saccade;
    case EyeMovementKind::no_data:
      break;
  }
  return movement.end - movement.start <= longest_hold ? GazeMark::blink : GazeMark::none;
}

/// A valid sample ends a gap, and belongs to the next movement.
bool leads_to(const EyeMovement& movement, const GazeSample& sample) {
  const bool ends_no_data = movement.kind == EyeMovementKind::no_data && sample.valid;
  return ends_no_data ? sample.time < movement.end : sample.time <= movement.end;
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

void GazeMarker::push(const GazeSample& sample, std::vector<GazeSample>& marked) {
  waiting_.push_back(sample);
  for (const EyeMovement& movement : detector_.push(sample)) {
    take(movement, marked);
  }
}

void GazeMarker::finish(std::vector<GazeSample>& marked) {
  if (const std::optional<EyeMovement> last = detector_.finish()) {
    take(*last, marked);
  }
  marked.insert(marked.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
}

void GazeMarker::take(const EyeMovement& movement, std::vector<GazeSample>& marked) {
  auto sample = waiting_.begin();
  for (; sample != waiting_.end() && leads_to(movement, *sample); ++sample) {
    sample->mark = mark_of(movement);
    marked.push_back(*sample);
  }
  waiting_.erase(waiting_.begin(), sample);
}

std::vector<MarkedMovement> marked_movements(std::span<const GazeSample> samples) {
  std::vector<MarkedMovement> movements;
  for (auto begin = samples.begin(); begin != samples.end();) {
    const auto end = std::find_if(
        begin, samples.end(), [&](const GazeSample& sample) { return sample.mark != begin->mark; });
    const Nanoseconds until = end == samples.end() ? samples.back().time : end->time;
    movements.push_back({begin->mark, {begin, end}, std::max(until - begin->time, Nanoseconds(0))});
    begin = end;
  }
  return movements;
}

}  // namespace foveola
