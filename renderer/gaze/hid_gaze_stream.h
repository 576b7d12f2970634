// Decodes what a HID eye tracker sends: where the eye looked, and when.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/device_clocks.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/hid_eye_reports.h"
#include "renderer/gaze/screen.h"

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

/// What has come from a device so far.
struct HidGazeCounters {
  std::uint64_t reports = 0;        ///< reports of tracking data
  std::uint64_t other_reports = 0;  ///< other reports that the device describes
  std::uint64_t wrong_ids = 0;      ///< reads, or what followed in one, with an id of no report
  std::uint64_t short_reads = 0;    ///< which ended before the report did
  /// Times that longer than one and a half periods went by between two reports. A device that does
  /// not see the eyes may send nothing.
  std::uint64_t gaps = 0;
  double rate_hz = 0.0;  ///< rate of the latest tracking reports; 0 before the second
};

/// Reads reports as they arrive, in their order. Its samples depend on its arguments alone.
class HidGazeStream {
 public:
  HidGazeStream(const HidEyeReports& reports, const HidGazeSettings& settings);

  /// Takes what feature reports say, as far as a device has them: the period of the reports, which
  /// is otherwise judged by their rate, and the size of the screen.
  void learn(const HidStatus& status);
  void learn(const HidConfiguration& configuration);

  /// Begins another connection of the same tracker: its clock and its reports may be different now,
  /// the counters go on.
  void reconnect(const HidEyeReports& reports);

  /// Takes the bytes of one read: a report, several behind one another if the reads were merged,
  /// or none that makes sense. Zeros behind a report are padding. Returns the gaze of the tracking
  /// reports among them, in their order; its direction is straight ahead if it is not valid.
  /// Arrivals may not go backwards between calls.
  std::vector<GazeSample> receive(std::span<const std::uint8_t> bytes, Nanoseconds arrival);

  const HidGazeCounters& counters() const { return counters_; }
  /// The newest that the device said, in a feature report that was learnt or an input report.
  const HidStatus& status() const { return status_; }
  const Screen& screen() const { return settings_.screen; }

 private:
  GazeSample take_tracking(const HidTrackingData& data, Nanoseconds arrival);
  void take_status(std::span<const std::uint8_t> report);
  void count_interval(std::optional<double> sensor_interval_s, Nanoseconds arrival);
  void count_rate(Nanoseconds arrival);
  std::optional<double> period_s() const;

  HidEyeReports reports_;
  HidGazeSettings settings_;
  HidStatus status_;
  HidSensorClock clock_;
  std::deque<Nanoseconds> arrivals_;  ///< arrival times of the latest tracking reports
  HidGazeCounters counters_;
};

}  // namespace foveola
