// An eye tracker that speaks the HID standard, read by a thread of its own: Linux queues 64 reports
// for a reader, so that one who reads once a frame sees the past.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/hid_device.h"
#include "renderer/gaze/hid_gaze_stream.h"

namespace foveola {

struct HidTrackerSettings {
  HidGazeSettings gaze;
  std::chrono::milliseconds retry{500};  ///< between attempts to find a tracker that is gone
};

/// What is known of the tracker and its connection.
struct HidTrackerState {
  bool is_connected = false;
  HidDeviceInfo device;  ///< the last that was open
  HidStatus status;
  std::optional<HidConfiguration> configuration;
  HidGazeCounters counters;       ///< sums over all connections
  std::uint64_t connections = 0;  ///< connections so far
  std::string status_text;  ///< why it is not connected, or does not do all; empty if all well
};

class HidEyeTracker final : public EyeTracker {
 public:
  /// Opens the tracker, again after each unplugging; empty if it is not there, and may throw Error.
  /// Called by the reading thread.
  using Opener = std::function<std::optional<HidConnection>()>;

  /// Begins to read at once, and to look for the tracker if it is not there. clock: must outlive
  /// the tracker and let several threads ask at a time; sample times are its.
  HidEyeTracker(Opener open, const Clock& clock, const HidTrackerSettings& settings);

  /// Ends the thread once its present read is over, after at most 50 ms, or the feature report or
  /// the opening that it is busy with.
  ~HidEyeTracker() override = default;
  HidEyeTracker(const HidEyeTracker&) = delete;
  HidEyeTracker& operator=(const HidEyeTracker&) = delete;

  /// What has arrived when it is called has arrived by `now`. A device that does not see the eyes
  /// may send nothing: then data are lost without an invalid sample, which only the samples'
  /// times show.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

  std::string status() const override { return state().status_text; }

  HidTrackerState state() const;

 private:
  void run(const std::stop_token& stop);
  /// Reads until the tracker is gone or `stop`, and returns why it is not connected any more.
  std::string connect_and_read(const std::stop_token& stop);
  /// Learns what the device says of itself and asks it for gaze.
  void set_up(const HidConnection& connection, const HidEyeReports& reports);
  void read_until_gone(const std::stop_token& stop, HidDevice& device,
                       std::size_t longest_report_bytes);
  void take(std::span<const std::uint8_t> bytes);
  void note_disconnected(const std::string& status_text);
  void wait_to_retry(const std::stop_token& stop);

  Opener open_;
  const Clock* clock_;
  HidTrackerSettings settings_;
  std::optional<HidGazeStream> stream_;  ///< the thread's own

  mutable std::mutex mutex_;  ///< guards the next two
  HidTrackerState state_;
  SampleQueue samples_;

  std::condition_variable_any retry_;
  std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace foveola
