// Eye trackers that are played to the kernel, read back through its HID core, hidraw, udev and
// hidapi. Needs uhid; run_in_qemu boots a kernel that has it.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "renderer/gaze/hid/hid_eye_tracker.h"
#include "tests/kernel_hid/uhid_device.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/hid_reference.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::Bytes;
using test::from_hex;
using test::operator+;
using test::UhidDevice;
using test::UhidSettings;

constexpr std::uint16_t reference_product = 0xABC0;
constexpr std::uint16_t hostile_product = 0xABC1;

/// Of the reference device: its screen is 0.6 m by 0.3 m.
const std::string gaze_request = "set 1401";

UhidSettings reference_device() {
  return {.vendor_id = 0x1234,
          .product_id = reference_product,
          .name = "Reference Eye Tracker",
          .serial_number = "4711",
          .report_descriptor = test::reference_descriptor(),
          .features = {{0x12, test::configuration_report(600'000, 300'000)},
                       {0x13, test::status_report(1, 120)}}};
}

/// The gaze walks down a diagonal of the screen in 240 steps.
Bytes report(int step) {
  return test::tracking_report(8333 * static_cast<std::uint64_t>(step), 2500 * step, 1250 * step);
}

/// Where that is if 90 degrees of a view fill the screen from left to right.
Vec3 direction_of_report(int step) {
  const float right = 2.0F * static_cast<float>(step) / 240.0F - 1.0F;
  return glm::normalize(Vec3(right, -0.5F * right, -1.0F));
}

/// Times are those of arrival.
HidTrackerSettings quick_settings() {
  return {.gaze = {.screen = {.width_m = 1.0,  // until the device says better
                              .height_m = 1.0,
                              .horizontal_fov_deg = 90.0,
                              .vertical_fov_deg = 53.13010235415598},
                   .use_sensor_clock = false},
          .retry = milliseconds(20)};
}

/// Reads the attached eye tracker of a product, and keeps each of its samples.
class WatchedTracker {
 public:
  explicit WatchedTracker(std::uint16_t product_id)
      : tracker_([product_id] { return open_hid_eye_tracker({.product_id = product_id}); }, clock_,
                 quick_settings()) {}

  HidTrackerState state() const { return tracker_.state(); }

  HidTrackerState wait_for(const std::string& what,
                           const std::function<bool(const HidTrackerState&)>& is_reached) const {
    HidTrackerState reached;
    test::wait_until(what, [&] {
      reached = state();
      return is_reached(reached);
    });
    return reached;
  }

  /// All samples so far, once there are so many.
  const std::vector<GazeSample>& wait_for_samples(std::size_t count) {
    test::wait_until(std::to_string(count) + " samples", [&] {
      tracker_.poll(clock_.now(), samples_);
      return samples_.size() >= count;
    });
    return samples_;
  }

 private:
  SteadyClock clock_;
  std::vector<GazeSample> samples_;
  HidEyeTracker tracker_;
};

/// Sends a step after the other and returns when it sent each. One that is late delays the others,
/// so that a machine which stands still for a while does not make them crowd.
std::vector<Nanoseconds> send_at_120_hz(const UhidDevice& device, int first, int count) {
  constexpr Nanoseconds period(8'333'333);
  std::vector<Nanoseconds> sent;
  auto next = std::chrono::steady_clock::now();
  for (int step = first; step < first + count; ++step) {
    const Bytes bytes = report(step);
    sent.push_back(SteadyClock().now());
    device.send(bytes);
    next = std::max(next + period, std::chrono::steady_clock::now());
    std::this_thread::sleep_until(next);
  }
  return sent;
}

void expect_step(const GazeSample& sample, int step) {
  EXPECT_TRUE(sample.valid) << step;
  EXPECT_LT(glm::distance(sample.direction, direction_of_report(step)), 1e-6F) << step;
}

HidDeviceInfo wait_until_listed(std::uint16_t product_id) {
  HidDeviceInfo info;
  test::wait_until("a device in the list", [&] {
    for (const HidDeviceInfo& listed : list_hid_eye_trackers()) {
      if (listed.product_id == product_id) {
        info = listed;
      }
    }
    return std::filesystem::exists(info.path);
  });
  return info;
}

/// A line that run_in_qemu shows.
void print_measured(const std::string& what) { fmt::print("measured: {}\n", what); }

void print_latency(const std::vector<Nanoseconds>& sent, const std::vector<GazeSample>& samples) {
  std::vector<double> latencies_ms;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    latencies_ms.push_back(1e3 * seconds(samples.at(i).time - sent[i]));
  }
  std::sort(latencies_ms.begin(), latencies_ms.end());
  const double count = static_cast<double>(latencies_ms.size());
  const double rate_hz = (count - 1.0) / seconds(sent.back() - sent.front());
  print_measured(fmt::format(
      "latency of delivery: mean {:.2f} ms, median {:.2f} ms, largest {:.2f} ms, of {} reports at "
      "{:.1f} Hz",
      std::accumulate(latencies_ms.begin(), latencies_ms.end(), 0.0) / count,
      latencies_ms[latencies_ms.size() / 2], latencies_ms.back(), count, rate_hz));
}

// Beside a mouse, in which there is a pointer, usage 1 on another page.
TEST(KernelHid, ListsTheDeviceOnceWithWhatItSaysOfItself) {
  const UhidDevice mouse({.vendor_id = 0x1234,
                          .product_id = hostile_product,
                          .name = "Mouse",
                          .report_descriptor = from_hex("05 01 09 02 a1 01 09 01 a1 00 09 30 09 31 "
                                                        "75 08 95 02 81 06 c0 c0")});
  const UhidDevice device(reference_device());
  const HidDeviceInfo info = wait_until_listed(reference_product);
  EXPECT_EQ(list_hid_eye_trackers().size(), 1U);
  EXPECT_EQ(info.vendor_id, 0x1234);
  EXPECT_EQ(info.product, "Reference Eye Tracker");
  EXPECT_EQ(info.serial_number, "4711");

  const HidConnection connection = open_hid_device(info);
  EXPECT_EQ(connection.report_descriptor, test::reference_descriptor());
  EXPECT_EQ(connection.device->get_feature_report(0x12, 19),
            test::configuration_report(600'000, 300'000));
  EXPECT_EQ(connection.device->get_feature_report(0x13, 4), test::status_report(1, 120));
  EXPECT_THAT(device.requests(), ElementsAre("get 12", "get 13"));
}

TEST(KernelHid, ReadsTheConfigurationBeforeItRequestsGaze) {
  const UhidDevice device(reference_device());
  const WatchedTracker tracker(reference_product);
  const HidTrackerState state = tracker.wait_for(
      "a connection", [](const HidTrackerState& reached) { return reached.is_connected; });
  EXPECT_THAT(device.requests(), ElementsAre("get 12", "get 13", gaze_request));
  EXPECT_EQ(state.status_text, "");
  EXPECT_NEAR(state.configuration.value().screen_width_m.value(), 0.6, 1e-12);
  EXPECT_NEAR(state.configuration.value().screen_height_m.value(), 0.3, 1e-12);
  EXPECT_EQ(state.status.sampling_frequency_hz, 120.0);
  EXPECT_EQ(state.status.configuration, HidConfigurationStatus::ready);
}

TEST(KernelHid, DeliversEveryReportInOrder) {
  constexpr int reports = 240;  // two seconds
  const UhidDevice device(reference_device());
  WatchedTracker tracker(reference_product);
  device.wait_for_request(gaze_request);
  const std::vector<Nanoseconds> sent = send_at_120_hz(device, 0, reports);
  const std::vector<GazeSample> samples = tracker.wait_for_samples(reports);
  for (int step = 0; step < reports; ++step) {
    expect_step(samples.at(static_cast<std::size_t>(step)), step);
  }
  print_latency(sent, samples);
}

// The kernel keeps 63 for a reader that is slow.
TEST(KernelHid, DeliversWhatCameAllAtOnce) {
  constexpr int reports = 60;
  const UhidDevice device(reference_device());
  WatchedTracker tracker(reference_product);
  device.wait_for_request(gaze_request);
  for (int step = 0; step < reports; ++step) {
    device.send(report(step));
  }
  const std::vector<GazeSample> samples = tracker.wait_for_samples(reports);
  for (int step = 0; step < reports; ++step) {
    expect_step(samples.at(static_cast<std::size_t>(step)), step);
  }
}

TEST(KernelHid, ComesBackWhenItIsPluggedInAgain) {
  std::optional<UhidDevice> device(std::in_place, reference_device());
  WatchedTracker tracker(reference_product);
  device->wait_for_request(gaze_request);
  send_at_120_hz(*device, 0, 20);
  tracker.wait_for_samples(20);

  device.reset();
  const HidTrackerState gone = tracker.wait_for(
      "status_text", [](const HidTrackerState& reached) { return !reached.is_connected; });
  EXPECT_THAT(gone.status_text,
              AnyOf("the eye tracker was unplugged", "no eye tracker is attached"));

  device.emplace(reference_device());
  device->wait_for_request(gaze_request);
  send_at_120_hz(*device, 100, 20);
  const std::vector<GazeSample> samples = tracker.wait_for_samples(40);
  for (int i = 0; i < 20; ++i) {
    expect_step(samples.at(static_cast<std::size_t>(i)), i);
    expect_step(samples.at(static_cast<std::size_t>(20 + i)), 100 + i);
  }
  EXPECT_EQ(tracker.state().status_text, "");
}

TEST(KernelHid, ComesBackIfItWasUnpluggedWhileItWasAsked) {
  UhidSettings silent = reference_device();
  silent.features[0x12] = {};
  std::optional<UhidDevice> device(std::in_place, silent);
  WatchedTracker tracker(reference_product);
  device->wait_for_request("get 12");
  device.reset();
  device.emplace(reference_device());
  device->wait_for_request(gaze_request);
  device->send(report(7));
  expect_step(tracker.wait_for_samples(1).front(), 7);
  EXPECT_EQ(tracker.state().status_text, "");
}

// The kernel waits five seconds for the answer that never comes.
TEST(KernelHid, ReadsADeviceThatAnswersBadly) {
  UhidSettings rude = reference_device();
  rude.features = {{0x12, from_hex("12 11 11")}, {0x13, Bytes{}}};
  const UhidDevice device(rude);
  WatchedTracker tracker(reference_product);
  device.wait_for_request(gaze_request);
  device.send(test::tracking_report(0, 500'000, 500'000));
  const GazeSample sample = tracker.wait_for_samples(1).front();
  // The middle of the screen that the settings state.
  EXPECT_LT(glm::distance(sample.direction, Vec3(0, 0, -1)), 1e-6F);
  EXPECT_FALSE(tracker.state().configuration);
  EXPECT_FALSE(tracker.state().status.sampling_frequency_hz);
}

// hidraw gives a reader one report a read, and drops what does not fit into its buffer. Whether it
// passes on reports that are too short depends on the kernel.
TEST(KernelHid, SurvivesMergedShortAndForeignReports) {
  const UhidDevice device(reference_device());
  WatchedTracker tracker(reference_product);
  device.wait_for_request(gaze_request);
  const Bytes whole = report(1);
  device.send(whole);
  device.send({whole.begin(), whole.begin() + 40});
  device.send(from_hex("55 01 02 03"));  // no report has this id
  device.send(report(2) + report(3));
  device.send(test::status_report(4, 60) + report(4));
  device.send(Bytes(4096, 0x10));  // too long, and its numbers are out of their range
  device.send(report(5));
  const std::vector<GazeSample> samples = tracker.wait_for_samples(4);
  expect_step(samples.at(0), 1);
  expect_step(samples.at(1), 2);
  EXPECT_FALSE(samples.at(2).valid);
  expect_step(samples.at(3), 5);

  const HidTrackerState state = tracker.state();
  EXPECT_TRUE(state.is_connected);
  EXPECT_EQ(state.status_text, "");
  EXPECT_EQ(state.status.configuration, HidConfigurationStatus::user_calibration_needed);
}

struct HostileDescriptor {
  std::string what;
  Bytes bytes;
  bool reaches_the_reader = false;  ///< or else the kernel refuses it
  std::string verdict;              ///< a part of the status that the reader reports
};

Bytes repeated(const std::string& digits, int times) {
  Bytes result;
  for (int i = 0; i < times; ++i) {
    result = result + from_hex(digits);
  }
  return result;
}

/// By the limits of Linux 6.1 (include/linux/hid.h; uhid: reports below 4 KiB) and those of the
/// reader (hid_report_descriptor.h).
std::vector<HostileDescriptor> hostile_descriptors() {
  const Bytes eye_tracker = from_hex("05 12 09 01 a1 01");
  const Bytes whole = test::reference_descriptor();
  const std::string kernel_refuses = "no eye tracker is attached";
  return {
      {.what = "cut off", .bytes = {whole.begin(), whole.begin() + 200}, .verdict = kernel_refuses},
      {.what = "2^32 - 1 numbers",
       .bytes = eye_tracker + from_hex("09 24 75 20 97 ff ff ff ff 09 21 81 02 c0"),
       .verdict = kernel_refuses},
      {.what = "a number of 2^32 - 1 bits",
       .bytes = eye_tracker + from_hex("09 24 77 ff ff ff ff 95 01 09 21 81 02 c0"),
       .verdict = kernel_refuses},
      {.what = "a hundred pushes",
       .bytes = eye_tracker + repeated("a4", 100) + from_hex("c0"),
       .verdict = kernel_refuses},
      {.what = "a hundred nested collections",
       .bytes = eye_tracker + repeated("a1 00", 100) + repeated("c0", 101),
       .reaches_the_reader = true,
       .verdict = "collections are nested too deeply"},
      {.what = "all usages there are, a bit each",
       .bytes = eye_tracker + from_hex("09 10 a1 02 09 24 a1 00 19 01 2a ff ff 15 00 25 01 75 01 "
                                       "96 00 20 81 02 c0 c0 c0"),
       .reaches_the_reader = true,
       .verdict = "sends no gaze point in a unit of length"},
      {.what = "a gaze point in 4 kB",
       .bytes = eye_tracker + from_hex("09 10 a1 02 09 24 a1 00 65 11 55 0c 17 80 7b e1 ff "
                                       "27 80 84 1e 00 75 20 95 02 09 21 09 22 81 02 c0 "
                                       "75 08 96 a0 0f 81 03 c0 c0"),
       .reaches_the_reader = true,
       .verdict = ""}};
}

/// Waits until the tracker knows why it does not read the device; empty if it does read it.
std::string verdict_of(const WatchedTracker& tracker) {
  return tracker
      .wait_for("a verdict",
                [](const HidTrackerState& state) {
                  return state.is_connected || !state.status_text.empty();
                })
      .status_text;
}

// The reference device is plugged in second, so that once its reports come, the kernel has looked
// at the hostile one.
TEST(KernelHid, HostileDescriptorsHarmNothing) {
  for (const HostileDescriptor& hostile : hostile_descriptors()) {
    SCOPED_TRACE(hostile.what);
    const UhidDevice attacker({.vendor_id = 0x1234,
                               .product_id = hostile_product,
                               .name = "Hostile",
                               .report_descriptor = hostile.bytes});
    const UhidDevice device(reference_device());
    WatchedTracker tracker(reference_product);
    device.wait_for_request(gaze_request);
    if (hostile.reaches_the_reader) {
      wait_until_listed(hostile_product);
    }
    const WatchedTracker victim(hostile_product);
    const std::string verdict = verdict_of(victim);
    EXPECT_THAT(verdict, HasSubstr(hostile.verdict));
    EXPECT_EQ(verdict.empty(), hostile.verdict.empty()) << verdict;
    attacker.send(Bytes(4096, 0xFF));
    device.send(report(3));
    expect_step(tracker.wait_for_samples(1).front(), 3);
    print_measured(fmt::format("hostile descriptor, {}: {}", hostile.what,
                               verdict.empty() ? "connected" : verdict));
  }
}

}  // namespace
}  // namespace foveola
