#include "tests/fuzz/hid_input.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "renderer/base/error.h"
#include "renderer/gaze/hid/hid_eye_reports.h"
#include "renderer/gaze/hid/hid_eye_tracker.h"
#include "renderer/gaze/hid/hid_report_descriptor.h"
#include "tests/fuzz/input_bytes.h"

namespace foveola::test {
namespace {

constexpr Nanoseconds period = std::chrono::milliseconds(8);
constexpr double latency_s = 0.014;

void check(const HidReportDescriptor& descriptor) {
  std::size_t fields = 0;
  for (const HidReport& report : descriptor.reports) {
    check_that(report.bit_size <= HidLimits::report_bits, "a report is too long");
    check_that(8 * report.size_bytes >= report.bit_size, "a report is longer than its bytes");
    fields += report.fields.size();
    for (const HidField& field : report.fields) {
      const std::uint64_t bits = std::uint64_t{field.bit_size} * field.count;
      check_that(field.bit_offset + bits <= report.bit_size, "a field is outside its report");
      check_that(field.logical_minimum <= field.logical_maximum, "a range is upside down");
      check_that(field.collections.size() <= HidLimits::collection_depth, "too deep");
    }
  }
  check_that(fields <= HidLimits::fields, "there are too many fields");
}

void check(const std::optional<HidNumber>& number, const HidReportShape& shape) {
  if (number) {
    check_that(number->bit_size >= 1 && number->bit_size <= 64, "a number has no size");
    check_that(number->bit_offset + number->bit_size <= 8 * shape.size_bytes,
               "a number is outside its report");
  }
}

void check(const HidTrackingReport& report) {
  check(report.sensor_time, report.shape);
  check(report.gaze_point.x, report.shape);
  check(report.gaze_point.y, report.shape);
}

void check(const std::optional<double>& value) {
  check_that(!value || std::isfinite(*value), "a value is not finite");
}

void check(const HidTrackingData& data) {
  check(data.sensor_time_s);
  check_that(!data.gaze_point_m || std::isfinite(glm::dot(*data.gaze_point_m, *data.gaze_point_m)),
             "a point is not finite");
}

void check(const GazeSample& sample, Nanoseconds arrival) {
  const Nanoseconds latest = arrival - nanoseconds_from_seconds(latency_s);
  check_that(sample.time <= latest && sample.time >= latest - std::chrono::seconds(1),
             "a sample is of another time");
  check_that(std::abs(glm::length(sample.direction) - 1.0F) < 1e-4F,
             "a direction is not of unit length");
}

void learn_from(const HidEyeReports& reports, Bytes read, HidGazeStream& stream) {
  if (reports.status_feature) {
    stream.learn(read_report(*reports.status_feature, read).value_or(HidStatus{}));
  }
  if (reports.configuration) {
    stream.learn(read_report(*reports.configuration, read).value_or(HidConfiguration{}));
  }
  if (reports.control) {
    check_that(encode_gaze_request(*reports.control).size() == reports.control->shape.size_bytes,
               "a request has another size");
  }
}

bool read_all(const HidEyeReports& reports, Bytes reads) {
  const Screen screen{
      .width_m = 0.6, .height_m = 0.3, .horizontal_fov_deg = 90.0, .vertical_fov_deg = 53.0};
  HidGazeStream stream(reports, {.screen = screen, .latency_s = latency_s});
  bool has_sample = false;
  for (Nanoseconds now(0); !reads.empty(); now += period) {
    const Bytes read = take(reads, take_number(reads, 1));
    learn_from(reports, read, stream);
    if (const auto data = read_report(reports.tracking, read)) {
      check(*data);
    }
    for (const GazeSample& sample : stream.receive(read, now)) {
      check(sample, now);
      has_sample = true;
    }
  }
  return has_sample;
}

}  // namespace

bool read_hid_input(std::span<const std::uint8_t> input) {
  try {
    const std::size_t descriptor_size = take_number(input, 2);
    const HidReportDescriptor descriptor = parse_report_descriptor(take(input, descriptor_size));
    check(descriptor);
    const HidEyeReports reports = find_eye_reports(descriptor);
    check(reports.tracking);
    return read_all(reports, input);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace foveola::test
