// Reports of an HID eye tracker (usage page 0x12, "Eye and Head Trackers", of the HID Usage Tables
// since 1.2; request HUTRR74): locates its measurements, and reads them in SI units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/gaze/hid/hid_items.h"
#include "renderer/gaze/hid/hid_report_descriptor.h"

namespace foveola {

inline constexpr std::uint16_t eye_and_head_trackers_page = 0x12;
inline constexpr std::uint16_t eye_tracker_usage = 0x01;

/// The shape that distinguishes a report from the device's others.
struct HidReportShape {
  std::uint8_t id = 0;         ///< its first byte; 0: without ids
  std::size_t size_bytes = 0;  ///< including the id
};

/// Whether `bytes` begin with a report of this shape.
enum class HidReportFit { fits, wrong_id, too_short };
HidReportFit fit_of(const HidReportShape& shape, std::span<const std::uint8_t> bytes);

struct HidPoint {
  std::optional<HidNumber> x, y;
};

/// The tracker's measurements, an input report. Absent measurements are empty.
struct HidTrackingReport {
  HidReportShape shape;
  std::optional<HidNumber> sensor_time;  ///< seconds since any origin
  HidPoint gaze_point;  ///< metres, from the top left of the screen rightwards and downwards
};

struct HidStatusReport {
  HidReportShape shape;
  std::optional<HidNumber> sampling_frequency;  ///< hertz
  std::optional<HidNumber> configuration_status;
};

struct HidControlReport {
  HidReportShape shape;
  HidNumber mode_request;
};

struct HidConfigurationReport {
  HidReportShape shape;
  std::optional<HidNumber> screen_width;   ///< metres, of the screen that it was calibrated to
  std::optional<HidNumber> screen_height;  ///< metres
};

/// The reports of the first eye tracker that a descriptor describes.
struct HidEyeReports {
  std::vector<HidReportShape> inputs;  ///< of all input reports, in the descriptor's order
  HidTrackingReport tracking;
  std::optional<HidStatusReport> status_input;
  std::optional<HidStatusReport> status_feature;
  std::optional<HidControlReport> control;              ///< a feature
  std::optional<HidConfigurationReport> configuration;  ///< a feature
};

/// Throws Error if the descriptor describes no eye tracker, or one without a gaze point in a unit
/// of length.
HidEyeReports find_eye_reports(const HidReportDescriptor& descriptor);

/// The content of a tracking report. Values missing in this report are empty too: those out of
/// their field's range, or the largest 32-bit number.
struct HidTrackingData {
  std::optional<double> sensor_time_s;
  std::optional<DVec2> gaze_point_m;
};

enum class HidConfigurationStatus {
  reserved = 0,
  ready = 1,
  configuring = 2,
  screen_setup_needed = 3,
  user_calibration_needed = 4,
};

struct HidStatus {
  std::optional<double> sampling_frequency_hz;
  std::optional<HidConfigurationStatus> configuration;
};

struct HidConfiguration {
  std::optional<double> screen_width_m;
  std::optional<double> screen_height_m;
};

/// Each reads the report at the beginning of `bytes`; nullopt unless it fits.
std::optional<HidTrackingData> read_report(const HidTrackingReport& report,
                                           std::span<const std::uint8_t> bytes);
std::optional<HidStatus> read_report(const HidStatusReport& report,
                                     std::span<const std::uint8_t> bytes);
std::optional<HidConfiguration> read_report(const HidConfigurationReport& report,
                                            std::span<const std::uint8_t> bytes);

/// The bytes of a control report that requests gaze points.
std::vector<std::uint8_t> encode_gaze_request(const HidControlReport& report);

/// Period of the sensor's clock in seconds; nullopt if it has none.
std::optional<double> sensor_clock_period_s(const HidTrackingReport& report);

}  // namespace foveola
