// The interface of all gaze sources, sources without a device, the queue between threads, and
// screens of trackers that measure points.
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

/// The eye's movement at a sample.
enum class GazeMark : std::uint8_t { none, fixation, saccade, blink };

struct GazeSample {
  Nanoseconds time{0};  ///< when the eye was there, by the same clock as `now`; see is_time_known
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, in the head's axes (-Z forward)
  bool valid = false;
  GazeMark mark = GazeMark::none;  ///< set by GazeMarker, never by a tracker
  bool is_time_known = true;       ///< otherwise `time` is that of the poll
};

class EyeTracker {
 public:
  virtual ~EyeTracker() = default;
  /// Appends all samples, valid or not, that arrived since the last call and by `now`, in order of
  /// arrival, without waiting. Called by one thread, once per frame; `now` must not decrease.
  virtual void poll(Nanoseconds now, std::vector<GazeSample>& arrived) = 0;
  /// The user's explanation for missing samples; empty if all is well.
  virtual std::string status() const { return {}; }
};

/// Always looks along `direction` (head's axes): one sample per poll, at `now`.
class FixedEyeTracker final : public EyeTracker {
 public:
  explicit FixedEyeTracker(const Vec3& direction) : direction_(direction) {}
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  Vec3 direction_;
};

/// A tracker with rate, delay and noise, which observes a simulated eye.
struct SimulatedTrackerSettings {
  double rate_hz = 120.0;       ///< > 0
  double latency_s = 0.010;     ///< from the eye to the host: half of FOVE 0's 8 ms, and 2 + 4 ms
  double precision_deg = 0.1;   ///< standard deviation along each axis
  double bias_right_deg = 0.0;  ///< added to the eye's azimuth
  double bias_up_deg = 0.0;     ///< added to the eye's elevation
  double data_loss = 0.0;       ///< share of invalid samples, in [0, 1]
  std::uint32_t seed = 0;
};

/// Samples the eye at multiples of 1 / rate_hz and delivers each sample latency_s later. Of the
/// samples before its first poll, it delivers only the newest.
class SimulatedEyeTracker final : public EyeTracker {
 public:
  /// true_gaze: the eye's direction in the head's axes at a time; nullopt during a blink.
  using TrueGaze = std::function<std::optional<Vec3>(Nanoseconds)>;
  SimulatedEyeTracker(const SimulatedTrackerSettings& settings, TrueGaze true_gaze);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  Nanoseconds exposure_time(std::int64_t index) const;
  /// Number of the last exposure at or before `time`; negative before the first.
  std::int64_t last_exposure(Nanoseconds time) const;
  /// The sample of the exposure with this number.
  GazeSample expose(std::int64_t index) const;

  SimulatedTrackerSettings settings_;
  TrueGaze true_gaze_;
  std::optional<std::int64_t> next_;  ///< number of the next exposure to deliver
};

/// Keeps samples in order of arrival. Not thread-safe: its owner must lock it.
class SampleQueue {
 public:
  /// Maximum number of samples without a poll, nine minutes at 120 Hz; beyond it the older half is
  /// dropped.
  static constexpr std::size_t capacity = 1U << 16U;

  /// Allocates no memory if polled every two seconds, at 120 Hz.
  SampleQueue() { samples_.reserve(256); }

  void push(std::span<const GazeSample> samples) {
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    if (samples_.size() > capacity) {
      samples_.erase(samples_.begin(), samples_.end() - capacity / 2);
    }
  }

  /// Moves all samples to the end of `arrived`.
  void take(std::vector<GazeSample>& arrived) {
    arrived.insert(arrived.end(), samples_.begin(), samples_.end());
    samples_.clear();
  }

 private:
  std::vector<GazeSample> samples_;
};

/// A screen filled by a flat view. The eye that sees it undistorted is on the axis through its
/// centre, which is the head's -Z.
struct Screen {
  double width_m = 0.0;             ///< > 0
  double height_m = 0.0;            ///< > 0
  double horizontal_fov_deg = 0.0;  ///< horizontal field of view of its content, in (0, 180)
  double vertical_fov_deg = 0.0;    ///< vertical field of view, in (0, 180)
};

/// The direction in the head's axes, unit length, of the point at `fraction` of the screen's width
/// and height, from its top left corner rightwards and downwards. Points beyond the screen (below
/// 0, above 1) are on its plane.
Vec3 direction_at(const Screen& screen, const DVec2& fraction);

/// The fraction of a point, given in metres right of and below the top left corner.
DVec2 fraction_of(const Screen& screen, const DVec2& metres);

/// Gaze from a pointer. One thread may move the pointer while another polls. A resting pointer
/// sends no events, and stays where its last event put it: its position is known at all times. The
/// newest sample has the time of the poll. Samples before it are evenly spaced at a mouse's typical
/// rate, 125 Hz, so that data quality does not depend on the frame rate. The delay of the mouse's
/// events is not included.
class PointerEyeTracker final : public EyeTracker {
 public:
  /// Moves the pointer at `time`. direction: unit length, in the head's axes; nullopt when the
  /// pointer has left the window, which makes samples invalid until it is back.
  void point_at(Nanoseconds time, const std::optional<Vec3>& direction);

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  std::mutex mutex_;                        ///< guards the members below
  std::vector<GazeSample> events_;          ///< since the last call, and the newest before it
  std::optional<Nanoseconds> last_sample_;  ///< time of the newest delivered sample
};

}  // namespace foveola
