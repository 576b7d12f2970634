// Passes a worn head's orientation and gaze from the thread that polls the headset to the others.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

/// Thread-safe.
class HeadsetMotion {
 public:
  /// Maximum number of stored orientations, the newest by time: those of a second or two.
  static constexpr std::size_t max_kept = 1024;

  HeadsetMotion();

  /// Records the head's orientation in the room at `time`. Forgets predictions for that time and
  /// later.
  void head_was(Nanoseconds time, const Quat& room_from_head);
  /// Forgets earlier orientations, which no longer hold after the room turned.
  void forget_past();
  void gaze_came(const GazeSample& sample);

  /// Turns the room so that straight ahead in it is this azimuth. The horizon stays level.
  void face(const AzimuthElevation& heading);
  Quat world_from_room() const;

  /// In the world, interpolated between recorded times, constant outside them. nullopt before the
  /// first.
  std::optional<Quat> head_at(Nanoseconds time) const;
  void take_gaze(std::vector<GazeSample>& arrived);
  /// The newest gaze in the world (unit length); nullopt if it is invalid or absent.
  std::optional<Vec3> newest_gaze() const;

 private:
  std::optional<Quat> head_at_locked(Nanoseconds time) const;

  struct Turned {
    Nanoseconds time{0};
    Quat room_from_head{1.0F, 0.0F, 0.0F, 0.0F};
  };

  mutable std::mutex mutex_;
  std::vector<Turned> past_;  ///< in order of time
  Quat world_from_room_{1.0F, 0.0F, 0.0F, 0.0F};
  SampleQueue gaze_;
  GazeSample newest_gaze_;
};

/// The worn head. Faces straight ahead until an orientation is known.
class HeadsetHead final : public HeadTracker {
 public:
  /// motion must outlive it.
  explicit HeadsetHead(HeadsetMotion& motion) : motion_(&motion) {}
  HeadPose pose(Nanoseconds now) override;
  HeadPose pose_at_gaze(Nanoseconds then, Nanoseconds now) override;
  void face(const AzimuthElevation& heading) override { motion_->face(heading); }

 private:
  HeadsetMotion* motion_;
};

/// The wearer's eyes.
class HeadsetEyes final : public EyeTracker {
 public:
  /// motion must outlive it. has_tracker: whether the headset has one.
  HeadsetEyes(HeadsetMotion& motion, bool has_tracker)
      : motion_(&motion), has_tracker_(has_tracker) {}
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override;

 private:
  HeadsetMotion* motion_;
  bool has_tracker_;
};

/// The runtime's answer to a query of the gaze.
struct ToldGaze {
  Nanoseconds asked{0};
  std::optional<Nanoseconds> sampled;  ///< nullopt if unknown
  Vec3 direction{0.0F, 0.0F, -1.0F};   ///< unit length, in the head's axes
  bool is_valid = false;
};

/// Converts repeated answers of a runtime to samples: it repeats each until the next.
class GazeTimes {
 public:
  /// nullopt for a repetition of the last sample. A sample has the time of the query if its own is
  /// unknown, in the future, not later than the last sample's or more than a second old.
  std::optional<GazeSample> sample_of(const ToldGaze& told);

 private:
  std::optional<ToldGaze> before_;
};

}  // namespace foveola
