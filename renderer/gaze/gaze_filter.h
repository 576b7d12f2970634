// Optional filters of a tracker's gaze: one holds it through blinks, one smooths it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// About the longest time that a blink lasts.
inline constexpr Nanoseconds longest_hold = std::chrono::milliseconds(600);

/// Keeps invalid samples back, so that the newest that passed stays the last valid one, with its
/// own time, until that is too old. From then on they pass, and one is added if the source sends
/// none.
class HoldFilter final : public EyeTracker {
 public:
  /// limit: the age (now less the sample's time) beyond which it is too old; in (0, longest_hold].
  explicit HoldFilter(std::unique_ptr<EyeTracker> source, Nanoseconds limit = longest_hold);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  std::unique_ptr<EyeTracker> source_;
  Nanoseconds limit_;
  std::optional<Nanoseconds> held_;  ///< the time of the last valid sample, until it is too old
  std::vector<GazeSample> polled_;
};

/// The defaults suit a simulated tracker of 120 Hz with 0.1 degrees of noise: a third of the noise
/// is left, and at the end of a saccade of 10 degrees 0.4 are still to go. To tune them, first
/// lower min_cutoff_hz with the eye at rest until jitter is gone, then raise beta until saccades no
/// longer lag.
struct OneEuroSettings {
  double min_cutoff_hz = 1.0;          ///< > 0: of the low pass for an eye at rest
  double beta_per_deg = 0.3;           ///< >= 0: Hz more for each degree per second
  double derivative_cutoff_hz = 10.0;  ///< > 0: of the low pass of the velocity
  /// After a longer time without samples it begins anew.
  Nanoseconds reset_after = std::chrono::milliseconds(100);
};

/// The 1-Euro filter (Casiez, Roussel and Vogel 2012, algorithms 1 and 2) on the sphere: a value is
/// a direction, a difference is a turn, and the derivative is an angular velocity, as a vector.
/// Along a great circle it is the published filter of the angle.
class OneEuro {
 public:
  explicit OneEuro(const OneEuroSettings& settings);

  /// The smoothed direction at `time`. The intervals between samples may differ. Of the same time
  /// as the last one: what it was; earlier: begins anew.
  Vec3 smoothed(Nanoseconds time, const Vec3& direction);

 private:
  struct State {
    Nanoseconds time{0};
    DVec3 direction{0.0, 0.0, -1.0};
    DVec3 velocity_deg_s{0.0, 0.0, 0.0};
  };

  OneEuroSettings settings_;
  std::optional<State> state_;
};

/// Smooths the valid samples that pass through it.
class OneEuroFilter final : public EyeTracker {
 public:
  OneEuroFilter(std::unique_ptr<EyeTracker> source, const OneEuroSettings& settings);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  std::unique_ptr<EyeTracker> source_;
  OneEuro filter_;
};

/// Which of the filters are wanted.
struct GazeFilterSettings {
  std::optional<Nanoseconds> hold;
  std::optional<OneEuroSettings> one_euro;
};

/// `source`, smoothed and then held, as wanted; `source` itself if neither is.
std::unique_ptr<EyeTracker> filtered(std::unique_ptr<EyeTracker> source,
                                     const GazeFilterSettings& settings);

}  // namespace foveola
