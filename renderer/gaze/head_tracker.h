// Where the head points: one interface for every source of head pose.
#pragma once

#include <functional>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"

namespace foveola {

struct HeadPose {
  Nanoseconds time{0};
  AzimuthElevation heading;  ///< world; the horizon stays level
};

class HeadTracker {
 public:
  virtual ~HeadTracker() = default;
  virtual HeadPose pose(Nanoseconds now) = 0;
};

/// Passes through given poses in time, turning at constant speed between them (the short way
/// round); before the first and after the last it stands still.
class ScriptedHeadTracker final : public HeadTracker {
 public:
  /// poses: at least one, times ascending. Throws Error otherwise.
  explicit ScriptedHeadTracker(std::vector<HeadPose> poses);
  HeadPose pose(Nanoseconds now) override;

 private:
  std::vector<HeadPose> poses_;
};

/// Follows a simulated head.
class SimulatedHeadTracker final : public HeadTracker {
 public:
  using TrueHeading = std::function<AzimuthElevation(Nanoseconds)>;
  explicit SimulatedHeadTracker(TrueHeading true_heading)
      : true_heading_(std::move(true_heading)) {}
  HeadPose pose(Nanoseconds now) override { return {.time = now, .heading = true_heading_(now)}; }

 private:
  TrueHeading true_heading_;
};

}  // namespace foveola
