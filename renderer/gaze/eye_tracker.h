// Where the eye looks: one interface for every source of gaze, sources without a device, the queue
// from the threads that read trackers, and the screens on which trackers see points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"

namespace foveola {

/// What the eye did at the time of a sample.
enum class GazeMark : std::uint8_t { none, fixation, saccade, blink };

struct GazeSample {
  Nanoseconds time{0};  ///< when the eye was there, by the same clock as `now`; see is_time_known
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, in the head's axes (-Z forward)
  bool valid = false;
  GazeMark mark = GazeMark::none;  ///< no tracker knows it: see GazeMarker
  bool is_time_known = true;       ///< else `time` is when the tracker was asked
};

class EyeTracker {
 public:
  virtual ~EyeTracker() = default;
  /// Appends what has arrived since the last call, by `now`, to `arrived`, without waiting for
  /// more: all samples, valid or not, in the order of their arrival. One thread calls it, once a
  /// frame, and `now` does not go backwards between calls.
  virtual void poll(Nanoseconds now, std::vector<GazeSample>& arrived) = 0;
  /// Why no samples come, for the user; empty if all is well.
  virtual std::string status() const { return {}; }
};

/// Always looks along `direction` (head's axes): whenever it is asked, one sample as of now.
class FixedEyeTracker final : public EyeTracker {
 public:
  explicit FixedEyeTracker(const Vec3& direction) : direction_(direction) {}
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  Vec3 direction_;
};

/// A tracker with a rate, a delay and noise, looking at a simulated eye.
struct SimulatedTrackerSettings {
  double rate_hz = 120.0;    ///< > 0
  double latency_s = 0.010;  ///< time from the eye to the host: half of FOVE 0's 8 ms, and 2 + 4 ms
  double precision_deg = 0.1;   ///< standard deviation along each axis
  double bias_right_deg = 0.0;  ///< what it adds to the eye's azimuth
  double bias_up_deg = 0.0;     ///< what it adds to the eye's elevation
  double data_loss = 0.0;       ///< the part of samples that come invalid, in [0, 1]
  std::uint32_t seed = 0;
};

/// Sees the eye at multiples of 1 / rate_hz and delivers each sample latency_s later. Of what it
/// saw before it was first asked, it delivers only the newest.
class SimulatedEyeTracker final : public EyeTracker {
 public:
  /// true_gaze gives the eye's direction in the head's axes at a time; empty while it blinks.
  using TrueGaze = std::function<std::optional<Vec3>(Nanoseconds)>;
  SimulatedEyeTracker(const SimulatedTrackerSettings& settings, TrueGaze true_gaze);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  Nanoseconds exposure_time(std::int64_t index) const;
  /// The number of the last exposure at or before `time`; negative before the first.
  std::int64_t last_exposure(Nanoseconds time) const;
  /// What the tracker saw at the exposure of this number.
  GazeSample expose(std::int64_t index) const;

  SimulatedTrackerSettings settings_;
  TrueGaze true_gaze_;
  std::optional<std::int64_t> next_;  ///< the number of the exposure to be delivered next
};

/// Keeps them in the order of their arrival. Its owner sees to it that one thread uses it at a
/// time.
class SampleQueue {
 public:
  /// The most samples kept while nobody polls, nine minutes at 120 Hz; beyond, the older half goes.
  static constexpr std::size_t capacity = 1U << 16U;

  /// Takes no new memory while it is polled every two seconds, at 120 Hz.
  SampleQueue() { samples_.reserve(256); }

  void push(std::span<const GazeSample> samples) {
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    if (samples_.size() > capacity) {
      samples_.erase(samples_.begin(), samples_.end() - capacity / 2);
    }
  }

  /// Appends all that it keeps to `arrived`, and keeps none of it any longer.
  void take(std::vector<GazeSample>& arrived) {
    arrived.insert(arrived.end(), samples_.begin(), samples_.end());
    samples_.clear();
  }

 private:
  std::vector<GazeSample> samples_;
};

/// A screen that a flat view fills. The eye that sees it undistorted is on the axis through its
/// middle, which is the head's -Z.
struct Screen {
  double width_m = 0.0;             ///< > 0
  double height_m = 0.0;            ///< > 0
  double horizontal_fov_deg = 0.0;  ///< field of view of what is shown on it, in (0, 180)
  double vertical_fov_deg = 0.0;    ///< vertical field of view, in (0, 180)
};

/// The direction in the head's axes, unit length, of the view's point at `fraction` of the screen's
/// width and height, from its top left corner rightwards and downwards. Points beyond the screen
/// (below 0, above 1) are on its plane.
Vec3 direction_at(const Screen& screen, const DVec2& fraction);

/// The fraction at a point that is so many metres right of and below the top left corner.
DVec2 fraction_of(const Screen& screen, const DVec2& metres);

/// One thread may move the pointer while another asks for gaze. A pointer that rests sends no
/// events and is known to be where the last one put it, so its position is known at all times. The
/// newest sample is as of when it is asked for. Samples before it fill the time since the last call
/// evenly at a mouse's usual rate, 125 Hz, so that how well the gaze is known does not depend on
/// how often frames ask for it. How long a hand's movement takes to become an event is not in it.
class PointerEyeTracker final : public EyeTracker {
 public:
  /// The pointer is there from `time` on. direction: unit length, in the head's axes; empty when
  /// the pointer has left the window, which makes samples invalid until it is back.
  void point_at(Nanoseconds time, const std::optional<Vec3>& direction);

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  std::mutex mutex_;                        ///< guards the members below
  std::vector<GazeSample> events_;          ///< since the last call, after the newest one before it
  std::optional<Nanoseconds> last_sample_;  ///< time of the newest sample that was given
};

}  // namespace foveola
