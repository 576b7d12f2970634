// The reports of an eye tracker that speaks the HID standard (usage page 0x12, "Eye and Head
// Trackers", of the HID Usage Tables since 1.2; request HUTRR74): where a device puts what it
// measures, and reading it in SI units.
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

/// How a report is distinguished from the device's others.
struct HidReportShape {
  std::uint8_t id = 0;         ///< its first byte; 0: the device's reports have no ids
  std::size_t size_bytes = 0;  ///< the id included
};

/// Whether a report of this shape is what `bytes` begin with.
enum class HidReportFit { fits, wrong_id, too_short };
HidReportFit fit_of(const HidReportShape& shape, std::span<const std::uint8_t> bytes);

struct HidPoint {
  std::optional<HidNumber> x, y;
};

/// The tracker's measurements, an input report. Whatever a device does not measure is empty.
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
  std::optional<HidNumber> screen_width;   ///< metres, of the screen it was calibrated to
  std::optional<HidNumber> screen_height;  ///< metres
};

/// The reports of the first eye tracker that a descriptor describes.
struct HidEyeReports {
  std::vector<HidReportShape> inputs;  ///< all that the device sends, in the descriptor's order
  HidTrackingReport tracking;
  std::optional<HidStatusReport> status_input;
  std::optional<HidStatusReport> status_feature;
  std::optional<HidControlReport> control;              ///< a feature
  std::optional<HidConfigurationReport> configuration;  ///< a feature
};

/// Throws Error if the descriptor describes no eye tracker or one that sends no gaze point in a
/// unit of length.
HidEyeReports find_eye_reports(const HidReportDescriptor& descriptor);

/// What one tracking report says. What the device did not measure this time is empty too: it is
/// out of its field's range, or the largest 32-bit number.
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

/// Each reads the report that `bytes` begin with; empty unless it fits.
std::optional<HidTrackingData> read_report(const HidTrackingReport& report,
                                           std::span<const std::uint8_t> bytes);
std::optional<HidStatus> read_report(const HidStatusReport& report,
                                     std::span<const std::uint8_t> bytes);
std::optional<HidConfiguration> read_report(const HidConfigurationReport& report,
                                            std::span<const std::uint8_t> bytes);

/// The bytes of a control report that requests the gaze point.
std::vector<std::uint8_t> encode_gaze_request(const HidControlReport& report);

/// After how many seconds the sensor's clock starts again from 0; empty if it has none.
std::optional<double> sensor_clock_period_s(const HidTrackingReport& report);

}  // namespace foveola
