#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/gaze/hid/hid_eye_tracker.h"
#include "tests/renderer/gaze/gaze_expectations.h"
#include "tests/renderer/gaze/hid_reference.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::Bytes;
using test::from_hex;
using test::operator+;
using test::tracking_report;

// Seen from 0.3 m, as in the test of screens.
constexpr Screen stream_screen{.width_m = 0.6,
                               .height_m = 0.3,
                               .horizontal_fov_deg = 90.0,
                               .vertical_fov_deg = 53.13010235415598};

HidEyeReports parsed_reports(const Bytes& descriptor) {
  return find_eye_reports(parse_report_descriptor(descriptor));
}

HidGazeStream stream_of(HidGazeSettings settings = {}) {
  settings.screen = stream_screen;
  return {parsed_reports(test::reference_descriptor()), settings};
}

/// The report number `index` of a 100 Hz tracker, with its time.
Bytes report_at_100_hz(int index) {
  return tracking_report(static_cast<std::uint64_t>(10'000 * index), 0, 0);
}

TEST(GazeStream, AReportWithoutAGazePointIsASampleThatIsNotValid) {
  HidGazeStream stream = stream_of({.latency_s = 0.014});
  const auto sample = newest(
      stream.receive(tracking_report(0, test::no_position, test::no_position), milliseconds(100)));
  ASSERT_TRUE(sample);
  EXPECT_FALSE(sample->valid);
  EXPECT_EQ(sample->time, milliseconds(86));
}

TEST(GazeStream, SamplesAreAsOldAsTheSensorSaysAndTheLatency) {
  HidGazeStream stream = stream_of({.latency_s = 0.014});
  EXPECT_EQ(newest(stream.receive(report_at_100_hz(0), milliseconds(100)))->time, milliseconds(86));
  // Read 20 ms late.
  const Nanoseconds late = newest(stream.receive(report_at_100_hz(1), milliseconds(130)))->time;
  EXPECT_NEAR(foveola::seconds(late), 0.096, 1e-6);
}

TEST(GazeStream, OrAsTheirArrivalIfTheSensorsClockIsNotUsed) {
  HidGazeStream stream = stream_of({.latency_s = 0.014, .use_sensor_clock = false});
  stream.receive(report_at_100_hz(0), milliseconds(100));
  EXPECT_EQ(newest(stream.receive(report_at_100_hz(1), milliseconds(130)))->time,
            milliseconds(116));
}

TEST(GazeStream, OrAsTheirArrivalIfThereIsNone) {
  HidGazeStream stream(
      parsed_reports(
          from_hex("05 12 09 01 a1 01 09 10 a1 02 16 18 fc 26 e8 03 65 11 55 0e 75 10 95 02 "
                   "09 24 a1 00 09 21 09 22 81 02 c0 c0 c0")),
      {.screen = stream_screen, .latency_s = 0.010});
  EXPECT_EQ(newest(stream.receive(from_hex("00 00 00 00"), milliseconds(100)))->time,
            milliseconds(90));
}

TEST(GazeStream, TheCalibratedScreenTakesTheSettingsPlace) {
  HidGazeStream stream = stream_of();
  stream.learn(HidConfiguration{.screen_width_m = 1.2, .screen_height_m = 0.6});
  EXPECT_EQ(stream.screen().width_m, 1.2);
  expect_along(
      newest(stream.receive(tracking_report(0, 600'000, 300'000), milliseconds(1)))->direction,
      {0, 0, -1});
  // Of sizes that were never set, nothing is learnt.
  stream.learn(HidConfiguration{.screen_width_m = 0.0, .screen_height_m = 0.0});
  stream.learn(HidConfiguration{.screen_width_m = 0.5});
  stream.learn(HidConfiguration{.screen_width_m = 2000.0, .screen_height_m = 0.5});
  EXPECT_EQ(stream.screen().width_m, 1.2);
  EXPECT_EQ(stream.screen().height_m, 0.6);
}

TEST(GazeStream, NoSampleIsValidBeforeTheSizeOfTheScreenIsKnown) {
  HidGazeStream stream(parsed_reports(test::reference_descriptor()),
                       {.screen = {.horizontal_fov_deg = 90.0, .vertical_fov_deg = 50.0}});
  const auto unknown =
      newest(stream.receive(tracking_report(0, 300'000, 150'000), milliseconds(1)));
  EXPECT_FALSE(unknown->valid);
  EXPECT_EQ(unknown->direction, Vec3(0, 0, -1));
  stream.learn(HidConfiguration{.screen_width_m = 0.6, .screen_height_m = 0.3});
  EXPECT_TRUE(
      newest(stream.receive(tracking_report(10, 300'000, 150'000), milliseconds(2)))->valid);
}

TEST(GazeStream, IgnoresWhatMakesNoSense) {
  HidGazeStream stream = stream_of();
  EXPECT_FALSE(newest(stream.receive(from_hex("77 00 00"), milliseconds(1))));
  EXPECT_FALSE(newest(stream.receive(Bytes(65, 0), milliseconds(1))));
  Bytes cut = report_at_100_hz(0);
  cut.pop_back();
  EXPECT_FALSE(newest(stream.receive(cut, milliseconds(2))));
  EXPECT_FALSE(newest(stream.receive(from_hex("13 01"), milliseconds(2))));
  EXPECT_FALSE(newest(stream.receive({}, milliseconds(2))));
  EXPECT_FALSE(newest(stream.receive(test::status_report(1, 100), milliseconds(3))));
}

TEST(GazeStream, TakesMergedReadsApart) {
  HidGazeStream stream = stream_of();
  const Bytes merged = test::status_report(1, 100) + tracking_report(1000, 0, 0) +
                       test::status_report(2, 100) + tracking_report(2000, 600'000, 0);
  const auto samples = stream.receive(merged, milliseconds(1));
  ASSERT_EQ(samples.size(), 2U);
  expect_along(samples[0].direction, {-0.3F, 0.15F, -0.3F});
  expect_along(samples[1].direction, {0.3F, 0.15F, -0.3F});
  EXPECT_EQ(stream.status().configuration, HidConfigurationStatus::configuring);
}

TEST(GazeStream, KeepsWhatCameBeforeTheReadBroke) {
  HidGazeStream stream = stream_of();
  EXPECT_TRUE(
      newest(stream.receive(tracking_report(1000, 0, 0) + from_hex("10 01 02"), milliseconds(1))));
  EXPECT_TRUE(
      newest(stream.receive(tracking_report(2000, 0, 0) + from_hex("99 10"), milliseconds(2))));
}

// Of a device whose reports have no ids, zeros could be one.
TEST(GazeStream, ZerosBehindAReportArePadding) {
  const Bytes descriptor = from_hex(
      "05 12 09 01 a1 01 09 10 a1 02 16 18 fc 26 e8 03 65 11 55 0e 75 10 95 02 09 24 a1 00 "
      "09 21 09 22 81 02 c0 c0 c0");
  HidGazeStream stream(parsed_reports(descriptor), {});
  EXPECT_EQ(stream.receive(from_hex("64 00 64 00 00 00 00 00"), milliseconds(1)).size(), 1U);
  EXPECT_EQ(stream.receive(from_hex("64 00 64 00 01 00 00 00"), milliseconds(2)).size(), 2U);
}

TEST(GazeStream, GoesOnAfterItIsConnectedAgain) {
  HidGazeStream stream = stream_of();
  stream.learn(HidStatus{.sampling_frequency_hz = 100.0});
  stream.receive(report_at_100_hz(500), milliseconds(100));
  stream.receive(report_at_100_hz(400), milliseconds(110));  // its clock jumped back
  stream.reconnect(parsed_reports(test::reference_descriptor()));
  EXPECT_FALSE(stream.status().sampling_frequency_hz);
  stream.learn(HidStatus{.sampling_frequency_hz = 100.0});
  // Neither the pause nor the clock that begins anew is a fault.
  const auto sample = newest(stream.receive(report_at_100_hz(0), milliseconds(9000)));
  EXPECT_EQ(sample->time, milliseconds(9000));
}

}  // namespace
}  // namespace foveola
