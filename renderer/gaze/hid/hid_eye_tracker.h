// An HID eye tracker with a reading thread of its own, since Linux queues 64 reports per reader:
// reading once per frame would lag. Decodes the gaze and its time.
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
  /// The screen that the tracker is calibrated to. A size reported by the device takes precedence.
  /// If only the device can know it, the size is 0 here, and without either no sample is valid.
  Screen screen;
  /// Minimum latency from eye position to arrival of its report, in seconds, >= 0: half the
  /// exposure, processing and transfer. The device does not report it; it is assumed.
  double latency_s = 0.0;
  /// Off: a report has its arrival's time, for a device with a wrong clock.
  bool use_sensor_clock = true;
};

/// Decodes reports in their order of arrival. Its samples depend on its arguments alone.
class HidGazeStream {
 public:
  HidGazeStream(const HidEyeReports& reports, const HidGazeSettings& settings);

  /// Applies the content of feature reports, as far as the device has it: its status, and the
  /// screen's size.
  void learn(const HidStatus& status);
  void learn(const HidConfiguration& configuration);

  /// Begins another connection of the same tracker, whose clock and reports may differ.
  void reconnect(const HidEyeReports& reports);

  /// Decodes the bytes of one read: a report, several if reads were merged, or garbage. Zeros
  /// behind a report are padding. Returns the gaze of the tracking reports, in order; the direction
  /// is straight ahead if invalid. Arrivals must not decrease between calls.
  std::vector<GazeSample> receive(std::span<const std::uint8_t> bytes, Nanoseconds arrival);

  /// The device's newest status, from a feature report or an input report.
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
  std::chrono::milliseconds retry{500};  ///< between attempts to reconnect
};

/// State of the tracker and its connection.
struct HidTrackerState {
  bool is_connected = false;
  HidDeviceInfo device;  ///< the last open device
  HidStatus status;
  std::optional<HidConfiguration> configuration;
  std::string status_text;  ///< why it is disconnected or limited; empty if all is well
};

class HidEyeTracker final : public EyeTracker {
 public:
  /// Opens the tracker, also after each unplugging. Returns nullopt if it is not there; may throw
  /// Error. Called by the reading thread.
  using Opener = std::function<std::optional<HidConnection>()>;

  /// Begins to connect and read at once. clock: of the samples, must outlive the tracker and be
  /// thread-safe.
  HidEyeTracker(Opener open, const Clock& clock, const HidTrackerSettings& settings);

  /// Ends the thread after its present read, at most 50 ms, or after the feature report or opening
  /// in progress.
  ~HidEyeTracker() override = default;
  HidEyeTracker(const HidEyeTracker&) = delete;
  HidEyeTracker& operator=(const HidEyeTracker&) = delete;

  /// Appends all reports that arrived by this call. A device that does not see the eyes may send
  /// nothing: data loss then shows only in the samples' times.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

  std::string status() const override { return state().status_text; }

  HidTrackerState state() const;

 private:
  void run(const std::stop_token& stop);
  /// Reads until the tracker is gone or `stop` is requested; returns the reason for the
  /// disconnection.
  std::string connect_and_read(const std::stop_token& stop);
  /// Reads the device's feature reports and requests gaze.
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
  std::jthread thread_;  ///< last: it ends before the members that it uses
};

}  // namespace foveola
