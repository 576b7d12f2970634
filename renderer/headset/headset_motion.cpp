#include "renderer/headset/headset_motion.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace foveola {
namespace {

constexpr Nanoseconds longest_delay = std::chrono::seconds(1);

}  // namespace

HeadsetMotion::HeadsetMotion() { past_.reserve(max_kept); }

void HeadsetMotion::head_was(Nanoseconds time, const Quat& room_from_head) {
  const std::scoped_lock lock(mutex_);
  while (!past_.empty() && past_.back().time >= time) {
    past_.pop_back();
  }
  if (past_.size() == max_kept) {
    past_.erase(past_.begin(), past_.begin() + max_kept / 2);
  }
  past_.push_back({.time = time, .room_from_head = room_from_head});
}

void HeadsetMotion::forget_past() {
  const std::scoped_lock lock(mutex_);
  past_.clear();
}

void HeadsetMotion::gaze_came(const GazeSample& sample) {
  const std::scoped_lock lock(mutex_);
  gaze_.push({&sample, 1});
  newest_gaze_ = sample;
}

void HeadsetMotion::face(const AzimuthElevation& heading) {
  const std::scoped_lock lock(mutex_);
  world_from_room_ = head_orientation({.azimuth_rad = heading.azimuth_rad});
}

Quat HeadsetMotion::world_from_room() const {
  const std::scoped_lock lock(mutex_);
  return world_from_room_;
}

std::optional<Quat> HeadsetMotion::head_at(Nanoseconds time) const {
  const std::scoped_lock lock(mutex_);
  return head_at_locked(time);
}

std::optional<Vec3> HeadsetMotion::newest_gaze() const {
  const std::scoped_lock lock(mutex_);
  const std::optional<Quat> head = head_at_locked(newest_gaze_.time);
  return head && newest_gaze_.valid ? std::optional(*head * newest_gaze_.direction) : std::nullopt;
}

std::optional<Quat> HeadsetMotion::head_at_locked(Nanoseconds time) const {
  if (past_.empty()) {
    return std::nullopt;
  }
  const auto after =
      std::lower_bound(past_.begin(), past_.end(), time,
                       [](const Turned& one, Nanoseconds sought) { return one.time < sought; });
  if (after == past_.begin() || after == past_.end()) {
    const Turned& nearest = after == past_.end() ? past_.back() : past_.front();
    return world_from_room_ * nearest.room_from_head;
  }
  const Turned& before = *std::prev(after);
  const double done = seconds(time - before.time) / seconds(after->time - before.time);
  return world_from_room_ * glm::normalize(glm::slerp(before.room_from_head, after->room_from_head,
                                                      static_cast<float>(done)));
}

void HeadsetMotion::take_gaze(std::vector<GazeSample>& arrived) {
  const std::scoped_lock lock(mutex_);
  gaze_.take(arrived);
}

HeadPose HeadsetHead::pose(Nanoseconds now) {
  const std::optional<Quat> head = motion_->head_at(now);
  return head_pose(now, head.value_or(motion_->world_from_room()));
}

HeadPose HeadsetHead::pose_at_gaze(Nanoseconds then, Nanoseconds /*now*/) { return pose(then); }

void HeadsetEyes::poll(Nanoseconds /*now*/, std::vector<GazeSample>& arrived) {
  motion_->take_gaze(arrived);
}

std::string HeadsetEyes::status() const {
  return has_tracker_ ? std::string() : "the headset has no eye tracker that OpenXR knows";
}

std::optional<GazeSample> GazeTimes::sample_of(const ToldGaze& told) {
  const std::optional<ToldGaze> before = std::exchange(before_, told);
  const bool has_same_time = before && told.sampled && before->sampled == told.sampled;
  if (has_same_time && before->direction == told.direction && before->is_valid == told.is_valid) {
    return std::nullopt;
  }
  const bool goes_on =
      !before || !before->sampled || !told.sampled || *told.sampled > *before->sampled;
  const bool is_time_known = told.sampled && goes_on && *told.sampled <= told.asked &&
                             told.asked - *told.sampled <= longest_delay;
  return GazeSample{.time = is_time_known ? *told.sampled : told.asked,
                    .direction = told.is_valid ? told.direction : Vec3(0.0F, 0.0F, -1.0F),
                    .valid = told.is_valid,
                    .is_time_known = is_time_known};
}

}  // namespace foveola
