#include "renderer/gaze/hid/hid_eye_reports.h"

#include <string>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/hid_reference.h"

namespace foveola {
namespace {

using test::Bytes;
using test::from_hex;
using test::operator+;

HidEyeReports reports_of(const Bytes& descriptor) {
  return find_eye_reports(parse_report_descriptor(descriptor));
}

HidEyeReports reference_reports() { return reports_of(test::reference_descriptor()); }

/// A descriptor with these items in the tracking data of an eye tracker.
Bytes tracker_with(const std::string& digits) {
  return from_hex("05 12 09 01 a1 01 09 10 a1 02 " + digits + " c0 c0");
}

/// Two positions of two bytes, -1000 to 1000 tenths of millimetres.
const std::string gaze_in_tenths =
    "16 18 fc 26 e8 03 65 11 55 0e 75 10 95 02 09 24 a1 00 09 21 09 22 81 02 c0 ";

TEST(EyeReports, FitByTheirIdAndTheirLength) {
  const HidReportShape shape{.id = 7, .size_bytes = 3};
  EXPECT_EQ(fit_of(shape, from_hex("07 00 00")), HidReportFit::fits);
  EXPECT_EQ(fit_of(shape, from_hex("07 00 00 01")), HidReportFit::fits);
  EXPECT_EQ(fit_of(shape, from_hex("07 00")), HidReportFit::too_short);
  EXPECT_EQ(fit_of(shape, from_hex("08 00 00")), HidReportFit::wrong_id);
  EXPECT_EQ(fit_of(shape, {}), HidReportFit::too_short);
  EXPECT_EQ(fit_of({.id = 0, .size_bytes = 2}, from_hex("08 00")), HidReportFit::fits);
}

TEST(EyeReports, OfTheReferenceDevice) {
  const HidEyeReports reports = reference_reports();
  EXPECT_EQ(reports.inputs.size(), 2U);
  EXPECT_EQ(reports.tracking.shape.id, 0x10);
  EXPECT_EQ(reports.tracking.shape.size_bytes, 65U);
  ASSERT_TRUE(reports.status_input && reports.status_feature && reports.control &&
              reports.configuration);
  EXPECT_EQ(reports.status_input->shape.size_bytes, 4U);
  EXPECT_EQ(reports.status_feature->shape.size_bytes, 4U);
  EXPECT_EQ(reports.control->shape.size_bytes, 2U);
  EXPECT_EQ(reports.configuration->shape.size_bytes, 19U);
}

TEST(EyeReports, ReadTrackingDataOfTheReferenceDevice) {
  const auto data = read_report(reference_reports().tracking,
                                test::tracking_report(0x0123456789ABCDEF, 250'000, -3));
  ASSERT_TRUE(data);
  EXPECT_NEAR(*data->sensor_time_s, 81985529216.486895, 1e-4);
  EXPECT_NEAR(data->gaze_point_m->x, 0.25, 1e-12);
  EXPECT_NEAR(data->gaze_point_m->y, -3e-6, 1e-12);
}

TEST(EyeReports, WhatIsOutOfRangeIsAbsent) {
  const HidTrackingReport tracking = reference_reports().tracking;
  const auto gaze = [&](std::int32_t x_um, std::int32_t y_um) {
    return read_report(tracking, test::tracking_report(1, x_um, y_um))->gaze_point_m;
  };
  EXPECT_TRUE(gaze(2'000'000, -2'000'000));
  EXPECT_FALSE(gaze(2'000'001, 0));
  EXPECT_FALSE(gaze(0, -2'000'001));
  EXPECT_FALSE(gaze(test::no_position, test::no_position));
}

TEST(EyeReports, TheLargestNumberIsAbsentEvenWithinItsRange) {
  const std::string positions = "65 11 55 0c 75 20 95 02 09 24 a1 00 09 21 09 22 81 02 c0";
  const std::string whole_range = "17 00 00 00 80 27 ff ff ff 7f ";
  for (const std::string& range : {std::string(), whole_range}) {
    const HidEyeReports reports = reports_of(tracker_with(range + positions));
    const Bytes zero = test::int32_bytes(0);
    EXPECT_TRUE(read_report(reports.tracking, zero + test::int32_bytes(test::no_position - 1))
                    ->gaze_point_m);
    EXPECT_FALSE(
        read_report(reports.tracking, zero + test::int32_bytes(test::no_position))->gaze_point_m);
  }
}

TEST(EyeReports, RefuseAnotherIdAndAShortReport) {
  const HidTrackingReport tracking = reference_reports().tracking;
  Bytes report = test::tracking_report(1, 2, 3);
  report.back() = 0;
  EXPECT_TRUE(read_report(tracking, report));
  report.pop_back();
  EXPECT_FALSE(read_report(tracking, report));
  report = test::tracking_report(1, 2, 3);
  report.front() = 0x13;
  EXPECT_FALSE(read_report(tracking, report));
}

TEST(EyeReports, ReadTheStatus) {
  const HidEyeReports reports = reference_reports();
  for (const auto& report : {reports.status_input, reports.status_feature}) {
    const auto status = read_report(*report, test::status_report(4, 120));
    EXPECT_EQ(status->sampling_frequency_hz, 120.0);
    EXPECT_EQ(status->configuration, HidConfigurationStatus::user_calibration_needed);
    EXPECT_FALSE(read_report(*report, test::status_report(5, 120))->configuration);
  }
}

TEST(EyeReports, ReadTheConfiguration) {
  const HidEyeReports reports = reference_reports();
  const auto configuration =
      read_report(*reports.configuration, test::configuration_report(531'360, 298'890));
  EXPECT_NEAR(*configuration->screen_width_m, 0.53136, 1e-12);
  EXPECT_NEAR(*configuration->screen_height_m, 0.29889, 1e-12);
}

TEST(EyeReports, RequestTheGazePoint) {
  const HidControlReport control = *reference_reports().control;
  EXPECT_EQ(test::to_hex(encode_gaze_request(control)), "1401");
}

// No ids, three reserved bytes first, a 32-bit time in milliseconds between the positions.
TEST(EyeReports, OfAnotherLayout) {
  const HidEyeReports reports =
      reports_of(tracker_with("75 08 95 03 81 03 " + gaze_in_tenths +
                              "15 00 27 ff ff ff ff 66 01 10 55 0d 75 20 95 01 09 20 81 02"));
  EXPECT_EQ(reports.tracking.shape.id, 0);
  EXPECT_EQ(reports.tracking.shape.size_bytes, 11U);
  EXPECT_FALSE(reports.status_feature || reports.control || reports.configuration);
  const auto data = read_report(reports.tracking, from_hex("00 00 00 e8 03 9c ff 10 27 00 00"));
  ASSERT_TRUE(data);
  EXPECT_NEAR(data->gaze_point_m->x, 0.1, 1e-12);
  EXPECT_NEAR(data->gaze_point_m->y, -0.01, 1e-12);
  EXPECT_NEAR(*data->sensor_time_s, 10.0, 1e-12);
  EXPECT_NEAR(*sensor_clock_period_s(reports.tracking), 4294967.296, 1e-6);
}

TEST(EyeReports, TheTimeMayBeOneNumberOf64Bits) {
  const HidEyeReports reports =
      reports_of(tracker_with("66 01 10 55 0a 75 40 95 01 09 20 81 02 " + gaze_in_tenths));
  const auto data = read_report(
      reports.tracking, test::little_endian(5'000'000'000'000, 8) + from_hex("00 00 00 00"));
  EXPECT_NEAR(*data->sensor_time_s, 5e6, 1e-6);
  EXPECT_NEAR(*sensor_clock_period_s(reports.tracking) / 18446744073709.551616, 1.0, 1e-12);
}

TEST(EyeReports, ATimeWithoutItsUnitIsNone) {
  const HidEyeReports reports =
      reports_of(tracker_with("75 08 95 08 09 20 81 02 " + gaze_in_tenths));
  EXPECT_FALSE(reports.tracking.sensor_time);
  EXPECT_FALSE(sensor_clock_period_s(reports.tracking));
}

// The last usage stands for all numbers that are left.
TEST(EyeReports, OfARepeatedPositionTheFirstCounts) {
  const HidEyeReports reports = reports_of(tracker_with(
      "16 18 fc 26 e8 03 65 11 55 0e 75 10 95 02 09 24 a1 00 09 22 81 02 09 21 81 02 c0"));
  const auto data = read_report(reports.tracking, from_hex("64 00 01 00 c8 00 02 00"));
  EXPECT_NEAR(data->gaze_point_m->y, 0.01, 1e-12);
  EXPECT_NEAR(data->gaze_point_m->x, 0.02, 1e-12);
}

TEST(EyeReports, NeedAnEyeTrackerThatSendsAGazePoint) {
  const Bytes mouse = from_hex("05 01 09 02 a1 01 09 30 09 31 75 08 95 02 81 06 c0");
  EXPECT_THAT([&] { reports_of(mouse); },
              ThrowsMessage<Error>(HasSubstr("it describes no eye tracker")));
  // Positions without a unit of length, and positions of a head tracker.
  const Bytes no_unit = tracker_with("75 10 95 02 09 24 a1 00 09 21 09 22 81 02 c0");
  EXPECT_THAT([&] { reports_of(no_unit); },
              ThrowsMessage<Error>(HasSubstr("sends no gaze point in a unit of length")));
  const Bytes head = from_hex("05 12 09 02 a1 01 09 10 a1 02 " + gaze_in_tenths + "c0 c0");
  EXPECT_THAT([&] { reports_of(head); },
              ThrowsMessage<Error>(HasSubstr("it describes no eye tracker")));
}

TEST(EyeReports, OfADeviceThatIsAMouseToo) {
  const Bytes mouse = from_hex("05 01 09 02 a1 01 85 01 09 30 09 31 75 08 95 02 81 06 c0");
  const HidEyeReports reports = reports_of(mouse + test::reference_descriptor());
  EXPECT_EQ(reports.inputs.size(), 3U);
  EXPECT_EQ(reports.tracking.shape.id, 0x10);
}

}  // namespace
}  // namespace foveola
