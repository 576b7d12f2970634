#include "renderer/gaze/hid/hid_eye_reports.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "renderer/base/error.h"

namespace foveola {
namespace {

// Entries of the usage page.
constexpr std::uint16_t tracking_data = 0x10;
constexpr std::uint16_t configuration = 0x12;
constexpr std::uint16_t tracker_status = 0x13;
constexpr std::uint16_t tracker_control = 0x14;
constexpr std::uint16_t sensor_timestamp = 0x20;
constexpr std::uint16_t position_x = 0x21;
constexpr std::uint16_t position_y = 0x22;
constexpr std::uint16_t gaze_point = 0x24;
constexpr std::uint16_t calibrated_screen_width = 0x204;
constexpr std::uint16_t calibrated_screen_height = 0x205;
constexpr std::uint16_t sampling_frequency = 0x300;
constexpr std::uint16_t configuration_status = 0x301;
constexpr std::uint16_t device_mode_request = 0x400;

HidUsage usage_of(std::uint16_t id) { return {.page = eye_and_head_trackers_page, .id = id}; }

/// The collections of an eye tracker that must enclose a number, among others.
using Within = std::initializer_list<std::uint16_t>;

bool is_within(const HidField& field, std::uint16_t collection) {
  return std::ranges::find(field.collections, usage_of(collection)) != field.collections.end();
}

bool is_within(const HidField& field, Within collections) {
  return is_within(field, eye_tracker_usage) &&
         std::ranges::all_of(
             collections, [&](std::uint16_t collection) { return is_within(field, collection); });
}

/// The first numbers with the usage, if they can be read as the quantity. A repeated usage is one
/// number in pieces if `in_pieces`, else its first number counts.
std::optional<HidNumber> find_number(const HidReport& report, Within collections,
                                     std::uint16_t usage, HidQuantity quantity,
                                     bool in_pieces = false) {
  for (const HidField& field : report.fields) {
    HidNumberRun run = numbers_with(field, usage_of(usage));
    if (run.count == 0 || !is_within(field, collections)) {
      continue;
    }
    if (!in_pieces) {
      run.count = 1;
    }
    if (const auto number = number_in(report, field, run, quantity)) {
      return number;
    }
  }
  return std::nullopt;
}

/// Excludes the largest 32-bit value, which means "none" in Microsoft's reference code (GazeHid,
/// GhostHid.c).
std::optional<HidNumber> without_largest(std::optional<HidNumber> number) {
  if (!number || number->bit_size != 32) {
    return number;
  }
  constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
  if (!number->has_limits) {
    number->has_limits = true;
    number->minimum = number->is_signed ? std::numeric_limits<std::int32_t>::min() : 0;
    number->maximum = largest;
  }
  number->maximum = std::min(number->maximum, largest - 1);
  return number;
}

std::optional<HidNumber> find_length(const HidReport& report, Within collections,
                                     std::uint16_t usage) {
  return without_largest(find_number(report, collections, usage, HidQuantity::length_m));
}

HidReportShape shape_of(const HidReport& report) {
  return {.id = report.id, .size_bytes = report.size_bytes};
}

std::optional<HidTrackingReport> as_tracking(const HidReport& report) {
  const Within within = {tracking_data, gaze_point};
  const HidPoint gaze{.x = find_length(report, within, position_x),
                      .y = find_length(report, within, position_y)};
  if (!gaze.x || !gaze.y) {
    return std::nullopt;
  }
  return HidTrackingReport{.shape = shape_of(report),
                           .sensor_time = find_number(report, {tracking_data}, sensor_timestamp,
                                                      HidQuantity::time_s, true),
                           .gaze_point = gaze};
}

std::optional<HidStatusReport> as_status(const HidReport& report) {
  const HidStatusReport status{
      .shape = shape_of(report),
      .sampling_frequency =
          find_number(report, {tracker_status}, sampling_frequency, HidQuantity::frequency_hz),
      .configuration_status =
          find_number(report, {tracker_status}, configuration_status, HidQuantity::count)};
  const bool is_one = status.sampling_frequency || status.configuration_status;
  return is_one ? std::optional(status) : std::nullopt;
}

std::optional<HidControlReport> as_control(const HidReport& report) {
  const auto mode = find_number(report, {tracker_control}, device_mode_request, HidQuantity::count);
  return mode ? std::optional(HidControlReport{.shape = shape_of(report), .mode_request = *mode})
              : std::nullopt;
}

std::optional<HidConfigurationReport> as_configuration(const HidReport& report) {
  const HidConfigurationReport found{
      .shape = shape_of(report),
      .screen_width = find_length(report, {configuration}, calibrated_screen_width),
      .screen_height = find_length(report, {configuration}, calibrated_screen_height)};
  return found.screen_width || found.screen_height ? std::optional(found) : std::nullopt;
}

/// The first report of this kind for which `read_as` succeeds.
template <typename ReadAs>
auto first_of(const HidReportDescriptor& descriptor, HidReportKind kind, ReadAs read_as)
    -> decltype(read_as(descriptor.reports.front())) {
  for (const HidReport& report : descriptor.reports) {
    if (report.kind == kind) {
      if (auto found = read_as(report)) {
        return found;
      }
    }
  }
  return std::nullopt;
}

bool describes_eye_tracker(const HidReportDescriptor& descriptor) {
  return std::ranges::any_of(descriptor.reports, [](const HidReport& report) {
    return std::ranges::any_of(
        report.fields, [](const HidField& field) { return is_within(field, eye_tracker_usage); });
  });
}

std::optional<double> read_number(const std::optional<HidNumber>& number,
                                  std::span<const std::uint8_t> bytes) {
  return number ? value_of(*number, bytes) : std::nullopt;
}

std::optional<DVec2> read_point(const HidPoint& point, std::span<const std::uint8_t> bytes) {
  const auto x = read_number(point.x, bytes);
  const auto y = read_number(point.y, bytes);
  return x && y ? std::optional(DVec2(*x, *y)) : std::nullopt;
}

std::optional<HidConfigurationStatus> read_configuration_status(
    const std::optional<HidNumber>& number, std::span<const std::uint8_t> bytes) {
  constexpr auto last = HidConfigurationStatus::user_calibration_needed;
  const std::optional<double> value = read_number(number, bytes);
  if (!value || *value < 0.0 || *value > static_cast<double>(last)) {
    return std::nullopt;
  }
  return static_cast<HidConfigurationStatus>(static_cast<int>(*value));
}

}  // namespace

HidReportFit fit_of(const HidReportShape& shape, std::span<const std::uint8_t> bytes) {
  if (shape.id != 0 && !bytes.empty() && bytes.front() != shape.id) {
    return HidReportFit::wrong_id;
  }
  return bytes.size() < shape.size_bytes ? HidReportFit::too_short : HidReportFit::fits;
}

HidEyeReports find_eye_reports(const HidReportDescriptor& descriptor) {
  const auto tracking = first_of(descriptor, HidReportKind::input, as_tracking);
  if (!tracking) {
    throw Error("HID report descriptor",
                describes_eye_tracker(descriptor)
                    ? "its eye tracker sends no gaze point in a unit of length"
                    : "it describes no eye tracker (usage page 0x12, usage 1)",
                "choose another device");
  }
  HidEyeReports reports{
      .tracking = *tracking,
      .status_input = first_of(descriptor, HidReportKind::input, as_status),
      .status_feature = first_of(descriptor, HidReportKind::feature, as_status),
      .control = first_of(descriptor, HidReportKind::feature, as_control),
      .configuration = first_of(descriptor, HidReportKind::feature, as_configuration)};
  for (const HidReport& report : descriptor.reports) {
    if (report.kind == HidReportKind::input) {
      reports.inputs.push_back(shape_of(report));
    }
  }
  return reports;
}

std::optional<HidTrackingData> read_report(const HidTrackingReport& report,
                                           std::span<const std::uint8_t> bytes) {
  if (fit_of(report.shape, bytes) != HidReportFit::fits) {
    return std::nullopt;
  }
  return HidTrackingData{.sensor_time_s = read_number(report.sensor_time, bytes),
                         .gaze_point_m = read_point(report.gaze_point, bytes)};
}

std::optional<HidStatus> read_report(const HidStatusReport& report,
                                     std::span<const std::uint8_t> bytes) {
  if (fit_of(report.shape, bytes) != HidReportFit::fits) {
    return std::nullopt;
  }
  return HidStatus{.sampling_frequency_hz = read_number(report.sampling_frequency, bytes),
                   .configuration = read_configuration_status(report.configuration_status, bytes)};
}

std::optional<HidConfiguration> read_report(const HidConfigurationReport& report,
                                            std::span<const std::uint8_t> bytes) {
  if (fit_of(report.shape, bytes) != HidReportFit::fits) {
    return std::nullopt;
  }
  return HidConfiguration{.screen_width_m = read_number(report.screen_width, bytes),
                          .screen_height_m = read_number(report.screen_height, bytes)};
}

std::vector<std::uint8_t> encode_gaze_request(const HidControlReport& report) {
  constexpr std::uint64_t gaze_point_mode = 1;
  std::vector<std::uint8_t> bytes(report.shape.size_bytes, 0);
  if (report.shape.id != 0) {
    bytes.front() = report.shape.id;
  }
  put_bits(report.mode_request, gaze_point_mode, bytes);
  return bytes;
}

std::optional<double> sensor_clock_period_s(const HidTrackingReport& report) {
  if (!report.sensor_time) {
    return std::nullopt;
  }
  const HidNumber& time = *report.sensor_time;
  const double ticks = time.has_limits ? static_cast<double>(time.maximum - time.minimum) + 1.0
                                       : std::ldexp(1.0, static_cast<int>(time.bit_size));
  return ticks * time.scale;
}

}  // namespace foveola
