// An eye tracker that speaks the HID standard, read by a thread of its own: Linux queues 64 reports
// for a reader, so that one who reads once a frame sees the past. Decodes where the eye looked, and
// when.
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
#include "renderer/gaze/device_clocks.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/hid/hid_device.h"
#include "renderer/gaze/hid/hid_eye_reports.h"

namespace foveola {

struct HidGazeSettings {
  /// What the tracker is calibrated to. A device that says how large that is knows better; if only
  /// the device can know, the size is 0, and without either no sample is valid.
  Screen screen;
  /// From the eye to the host for the report with the shortest way, in seconds, >= 0: the middle of
  /// the exposure, processing and transfer. The device says nothing of it; it is assumed.
  double latency_s = 0.0;
  /// Off: reports count from when they arrive, for a device whose clock is wrong.
  bool use_sensor_clock = true;
};

/// Reads reports as they arrive, in their order. Its samples depend on its arguments alone.
class HidGazeStream {
 public:
  HidGazeStream(const HidEyeReports& reports, const HidGazeSettings& settings);

  /// Takes what feature reports say, as far as a device has them: its status, and the size of the
  /// screen.
  void learn(const HidStatus& status);
  void learn(const HidConfiguration& configuration);

  /// Begins another connection of the same tracker: its clock and its reports may be different now.
  void reconnect(const HidEyeReports& reports);

  /// Takes the bytes of one read: a report, several behind one another if the reads were merged,
  /// or none that makes sense. Zeros behind a report are padding. Returns the gaze of the tracking
  /// reports among them, in their order; its direction is straight ahead if it is not valid.
  /// Arrivals may not go backwards between calls.
  std::vector<GazeSample> receive(std::span<const std::uint8_t> bytes, Nanoseconds arrival);

  /// The newest that the device said, in a feature report that was learnt or an input report.
  const HidStatus& status() const { return status_; }
  const Screen& screen() const { return settings_.screen; }

 private:
  GazeSample take_tracking(const HidTrackingData& data, Nanoseconds arrival);
  void take_status(std::span<const std::uint8_t> report);

  HidEyeReports reports_;
  HidGazeSettings settings_;
  HidStatus status_;
  HidSensorClock clock_;
};

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
