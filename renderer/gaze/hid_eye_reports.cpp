#include "renderer/gaze/hid_eye_reports.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "renderer/base/error.h"

namespace foveola {
namespace {

// Entries of the usage page.
constexpr std::uint16_t tracking_data = 0x10;
constexpr std::uint16_t capabilities = 0x11;
constexpr std::uint16_t configuration = 0x12;
constexpr std::uint16_t tracker_status = 0x13;
constexpr std::uint16_t tracker_control = 0x14;
constexpr std::uint16_t sensor_timestamp = 0x20;
constexpr std::uint16_t position_x = 0x21;
constexpr std::uint16_t position_y = 0x22;
constexpr std::uint16_t position_z = 0x23;
constexpr std::uint16_t gaze_point = 0x24;
constexpr std::uint16_t left_eye_position = 0x25;
constexpr std::uint16_t right_eye_position = 0x26;
constexpr std::uint16_t head_position = 0x27;
constexpr std::uint16_t rotation_about_x = 0x29;
constexpr std::uint16_t rotation_about_y = 0x2A;
constexpr std::uint16_t rotation_about_z = 0x2B;
constexpr std::uint16_t tracker_quality = 0x100;
constexpr std::uint16_t minimum_tracking_distance = 0x101;
constexpr std::uint16_t optimum_tracking_distance = 0x102;
constexpr std::uint16_t maximum_tracking_distance = 0x103;
constexpr std::uint16_t maximum_screen_plane_width = 0x104;
constexpr std::uint16_t maximum_screen_plane_height = 0x105;
constexpr std::uint16_t calibrated_screen_width = 0x204;
constexpr std::uint16_t calibrated_screen_height = 0x205;
constexpr std::uint16_t sampling_frequency = 0x300;
constexpr std::uint16_t configuration_status = 0x301;
constexpr std::uint16_t device_mode_request = 0x400;

HidUsage usage_of(std::uint16_t id) { return {.page = eye_and_head_trackers_page, .id = id}; }

/// The collections of an eye tracker that enclose a number, whatever else does.
using Within = std::initializer_list<std::uint16_t>;

bool is_within(const HidField& field, std::uint16_t collection) {
  return std::find(field.collections.begin(), field.collections.end(), usage_of(collection)) !=
         field.collections.end();
}

bool is_within(const HidField& field, Within collections) {
  return is_within(field, eye_tracker_usage) &&
         std::all_of(collections.begin(), collections.end(),
                     [&](std::uint16_t collection) { return is_within(field, collection); });
}

/// The first numbers with the usage, if they can be read as the quantity. A repeated usage is one
/// number in pieces if that is `in_pieces`, else its first number counts.
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

/// The number with the largest 32-bit value out of its limits, which stands for "none" in
/// Microsoft's reference code (GazeHid, GhostHid.c).
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

HidPoint find_position(const HidReport& report, std::uint16_t collection) {
  const Within within = {tracking_data, collection};
  return {.x = find_length(report, within, position_x),
          .y = find_length(report, within, position_y),
          .z = find_length(report, within, position_z)};
}

/// The rotations are the head's, whatever collection they are in.
HidPoint find_head_rotation(const HidReport& report) {
  const auto angle_about = [&](std::uint16_t axis) {
    return without_largest(find_number(report, {tracking_data}, axis, HidQuantity::angle_rad));
  };
  return {.x = angle_about(rotation_about_x),
          .y = angle_about(rotation_about_y),
          .z = angle_about(rotation_about_z)};
}

HidReportShape shape_of(const HidReport& report) {
  return {.id = report.id, .size_bytes = report.size_bytes};
}

std::optional<HidTrackingReport> as_tracking(const HidReport& report) {
  const HidPoint gaze = find_position(report, gaze_point);
  if (!gaze.x || !gaze.y) {
    return std::nullopt;
  }
  return HidTrackingReport{.shape = shape_of(report),
                           .sensor_time = find_number(report, {tracking_data}, sensor_timestamp,
                                                      HidQuantity::time_s, true),
                           .gaze_point = gaze,
                           .left_eye = find_position(report, left_eye_position),
                           .right_eye = find_position(report, right_eye_position),
                           .head = find_position(report, head_position),
                           .head_rotation = find_head_rotation(report)};
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

std::optional<HidCapabilitiesReport> as_capabilities(const HidReport& report) {
  const auto length = [&](std::uint16_t usage) {
    return find_length(report, {capabilities}, usage);
  };
  const HidCapabilitiesReport found{
      .shape = shape_of(report),
      .tracker_quality = find_number(report, {capabilities}, tracker_quality, HidQuantity::count),
      .minimum_distance = length(minimum_tracking_distance),
      .optimum_distance = length(optimum_tracking_distance),
      .maximum_distance = length(maximum_tracking_distance),
      .maximum_screen_width = length(maximum_screen_plane_width),
      .maximum_screen_height = length(maximum_screen_plane_height)};
  const bool is_one = found.tracker_quality || found.minimum_distance || found.optimum_distance ||
                      found.maximum_distance || found.maximum_screen_width ||
                      found.maximum_screen_height;
  return is_one ? std::optional(found) : std::nullopt;
}

/// The first report of this kind of which `read_as` makes something.
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
  return std::any_of(
      descriptor.reports.begin(), descriptor.reports.end(), [](const HidReport& report) {
        return std::any_of(report.fields.begin(), report.fields.end(), [](const HidField& field) {
          return is_within(field, eye_tracker_usage);
        });
      });
}

std::optional<double> read_number(const std::optional<HidNumber>& number,
                                  std::span<const std::uint8_t> bytes) {
  return number ? value_of(*number, bytes) : std::nullopt;
}

std::optional<DVec3> read_point(const HidPoint& point, std::span<const std::uint8_t> bytes) {
  const auto x = read_number(point.x, bytes);
  const auto y = read_number(point.y, bytes);
  const auto z = read_number(point.z, bytes);
  return x && y && z ? std::optional(DVec3(*x, *y, *z)) : std::nullopt;
}

std::optional<DVec2> read_plane_point(const HidPoint& point, std::span<const std::uint8_t> bytes) {
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
      .configuration = first_of(descriptor, HidReportKind::feature, as_configuration),
      .capabilities = first_of(descriptor, HidReportKind::feature, as_capabilities)};
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
                         .gaze_point_m = read_plane_point(report.gaze_point, bytes),
                         .gaze_point_z_m = read_number(report.gaze_point.z, bytes),
                         .left_eye_m = read_point(report.left_eye, bytes),
                         .right_eye_m = read_point(report.right_eye, bytes),
                         .head_m = read_point(report.head, bytes),
                         .head_rotation_rad = read_point(report.head_rotation, bytes)};
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

std::optional<HidCapabilities> read_report(const HidCapabilitiesReport& report,
                                           std::span<const std::uint8_t> bytes) {
  if (fit_of(report.shape, bytes) != HidReportFit::fits) {
    return std::nullopt;
  }
  HidCapabilities read{.minimum_distance_m = read_number(report.minimum_distance, bytes),
                       .optimum_distance_m = read_number(report.optimum_distance, bytes),
                       .maximum_distance_m = read_number(report.maximum_distance, bytes),
                       .maximum_screen_width_m = read_number(report.maximum_screen_width, bytes),
                       .maximum_screen_height_m = read_number(report.maximum_screen_height, bytes)};
  if (const auto quality = read_number(report.tracker_quality, bytes)) {
    read.tracks_fine_gaze = *quality == 1.0;
  }
  return read;
}

std::vector<std::uint8_t> mode_request(const HidControlReport& report, std::uint64_t mode) {
  std::vector<std::uint8_t> bytes(report.shape.size_bytes, 0);
  if (report.shape.id != 0) {
    bytes.front() = report.shape.id;
  }
  put_bits(report.mode_request, mode, bytes);
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
