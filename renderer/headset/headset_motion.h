// Where a worn head is turned and where its eyes look: from the thread that asks the headset to
// those that follow it.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

/// All of it may be called by any thread.
class HeadsetMotion {
 public:
  /// How many orientations are kept at most, of the newest of times: those of a second or two.
  static constexpr std::size_t max_kept = 1024;

  HeadsetMotion();

  /// The head's orientation in the room at `time`. What was foretold of that time and later ones is
  /// forgotten.
  void head_was(Nanoseconds time, const Quat& room_from_head);
  /// What is known of times before may not be as it is now: the room has turned.
  void forget_past();
  void gaze_came(const GazeSample& sample);

  /// The room turns, so that who looks straight ahead in it looks along this azimuth. The horizon
  /// stays level.
  void face(const AzimuthElevation& heading);
  Quat world_from_room() const;

  /// In the world, between what is known of before and after; before and beyond, the nearest. Empty
  /// as long as nothing is known.
  std::optional<Quat> head_at(Nanoseconds time) const;
  void take_gaze(std::vector<GazeSample>& arrived);
  /// The newest one in the world (unit length); empty if it is not valid, or there is none.
  std::optional<Vec3> newest_gaze() const;

 private:
  std::optional<Quat> head_at_locked(Nanoseconds time) const;

  struct Turned {
    Nanoseconds time{0};
    Quat room_from_head{1.0F, 0.0F, 0.0F, 0.0F};
  };

  mutable std::mutex mutex_;
  std::vector<Turned> past_;  ///< in the order of time
  Quat world_from_room_{1.0F, 0.0F, 0.0F, 0.0F};
  SampleQueue gaze_;
  GazeSample newest_gaze_;
};

/// The worn head. Looks straight ahead as long as nothing is known.
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

/// Its wearer's eyes.
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

/// What the runtime told when it was asked.
struct ToldGaze {
  Nanoseconds asked{0};
  std::optional<Nanoseconds> sampled;  ///< empty: it does not know
  Vec3 direction{0.0F, 0.0F, -1.0F};   ///< unit length, in the head's axes
  bool is_valid = false;
};

/// Turns what a runtime tells, asked again and again, into samples: the same one is told until
/// there is another.
class GazeTimes {
 public:
  /// Empty if this is the sample before. A time that is unknown, to come, not later than that of
  /// the sample before or more than a second ago is no time: the sample then has the one at which
  /// it was asked for.
  std::optional<GazeSample> sample_of(const ToldGaze& told);

 private:
  std::optional<ToldGaze> before_;
};

}  // namespace foveola
