#include "renderer/gaze/hid/hid_eye_tracker.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/hid_reference.h"
#include "tests/renderer/gaze/newest_gaze.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::Bytes;
using test::from_hex;
using test::NewestGaze;
using test::operator+;
using test::tracking_report;

/// What reads of a device return: bytes, or that it is gone. Afterwards it has nothing to say.
using Reads = std::deque<std::optional<Bytes>>;

/// What was asked of the devices of a test, in order.
class CallLog {
 public:
  void add(const std::string& call) {
    const std::lock_guard lock(mutex_);
    calls_.push_back(call);
  }
  std::vector<std::string> calls() const {
    const std::lock_guard lock(mutex_);
    return calls_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> calls_;
};

/// The reference device, ready at 120 Hz, in front of a screen of 0.6 m by 0.3 m.
class ScriptedDevice : public HidDevice {
 public:
  ScriptedDevice(Reads reads, CallLog& log) : reads_(std::move(reads)), log_(&log) {}

  std::optional<std::size_t> read(std::span<std::uint8_t> buffer, milliseconds timeout) override {
    if (reads_.empty()) {
      std::this_thread::sleep_for(std::min(timeout, milliseconds(1)));
      return 0;
    }
    const std::optional<Bytes> next = reads_.front();
    reads_.pop_front();
    if (!next) {
      return std::nullopt;
    }
    const std::size_t size_bytes = std::min(next->size(), buffer.size());
    std::copy_n(next->begin(), size_bytes, buffer.begin());
    return size_bytes;
  }

  std::optional<Bytes> get_feature_report(std::uint8_t id, std::size_t size_bytes) override {
    log_->add("get " + test::to_hex({id}));
    Bytes report;
    if (id == 0x12) {
      report = test::configuration_report(600'000, 300'000);
    } else if (id == 0x13) {
      report = test::status_report(1, 120);
    }
    EXPECT_EQ(report.size(), size_bytes);
    return report;
  }

  bool send_feature_report(std::uint8_t id, std::span<const std::uint8_t> report) override {
    log_->add("send " + test::to_hex({id}) + " " + test::to_hex({report.begin(), report.end()}));
    return true;
  }

 private:
  Reads reads_;
  CallLog* log_;
};

HidConnection connection_to(std::unique_ptr<HidDevice> device,
                            const Bytes& descriptor = test::reference_descriptor()) {
  return {.info = {.product = "Scripted"},
          .report_descriptor = descriptor,
          .device = std::move(device)};
}

/// Opens one device after the other, then none any more.
HidEyeTracker::Opener opener_of(std::vector<Reads> devices, CallLog& log) {
  return [devices = std::move(devices), &log, next = std::size_t{0}]() mutable {
    log.add("open");
    return next < devices.size() ? std::optional(connection_to(std::make_unique<ScriptedDevice>(
                                       std::move(devices[next++]), log)))
                                 : std::nullopt;
  };
}

constexpr Screen half_metre{.width_m = 1.0,  // until the device says better
                            .height_m = 1.0,
                            .horizontal_fov_deg = 90.0,
                            .vertical_fov_deg = 53.13010235415598};

HidTrackerSettings quick_settings() {
  return {.gaze = {.screen = half_metre}, .retry = milliseconds(1)};
}

/// Waits until the tracker's state is such, however slow the machine; throws if it never is.
HidTrackerState wait_for(const HidEyeTracker& tracker,
                         const std::function<bool(const HidTrackerState&)>& is_reached) {
  HidTrackerState state;
  test::wait_until("the tracker's state", [&] {
    state = tracker.state();
    return is_reached(state);
  });
  return state;
}

bool is_connected(const HidTrackerState& state) { return state.is_connected; }

TEST(HidEyeTracker, ReadsTheConfigurationBeforeItRequestsGaze) {
  const SteadyClock clock;
  CallLog log;
  HidEyeTracker tracker(opener_of({Reads{}}, log), clock, quick_settings());
  const HidTrackerState state = wait_for(tracker, is_connected);
  EXPECT_THAT(log.calls(), ElementsAre("open", "get 12", "get 13", "send 14 1401"));
  EXPECT_NEAR(*state.configuration->screen_width_m, 0.6, 1e-12);
  EXPECT_EQ(state.status.sampling_frequency_hz, 120.0);
  EXPECT_EQ(state.status.configuration, HidConfigurationStatus::ready);
}

// Each report is where the one before was not, so that a lost or swapped one shows.
TEST(HidEyeTracker, DeliversTheSampleOfEachReportInOrder) {
  const SteadyClock clock;
  CallLog log;
  Reads reads;
  for (int i = 0; i < 240; ++i) {
    reads.push_back(tracking_report(8333 * static_cast<std::uint64_t>(i), 2500 * i, 150'000));
  }
  reads.push_back(test::status_report(2, 120));  // no reason to forget the gaze
  HidEyeTracker tracker(opener_of({reads}, log), clock, quick_settings());
  wait_for(tracker, [](const HidTrackerState& s) {
    return s.status.configuration == HidConfigurationStatus::configuring;
  });
  const Nanoseconds now = clock.now();
  std::vector<GazeSample> arrived;
  tracker.poll(now, arrived);
  ASSERT_EQ(arrived.size(), 240U);
  for (int i = 0; i < 240; ++i) {
    EXPECT_TRUE(arrived[i].valid);
    EXPECT_LE(arrived[i].time, now);
    // At so many of the 240 parts of the screen, of which 90 degrees are seen.
    const Vec3 expected =
        glm::normalize(Vec3(2.0F * static_cast<float>(i) / 240.0F - 1.0F, 0.0F, -1.0F));
    EXPECT_LT(glm::distance(arrived[i].direction, expected), 1e-6F);
  }
}

TEST(HidEyeTracker, ComesBackWhenItIsPluggedInAgain) {
  const SteadyClock clock;
  CallLog log;
  const Bytes first = tracking_report(900'000'000, 0, 0);
  const Bytes second = tracking_report(5, 600'000, 300'000);
  const Reads before = {first, first, std::nullopt};
  const Reads after = {second};
  // Opens once each time that the test plugs it in.
  std::atomic<bool> is_plugged_in = true;
  const auto open = [open_next = opener_of({before, after}, log), &is_plugged_in] {
    return is_plugged_in.exchange(false) ? open_next() : std::nullopt;
  };
  HidEyeTracker tracker(open, clock, quick_settings());
  NewestGaze newest(tracker);
  const HidTrackerState state = wait_for(tracker, [](const HidTrackerState& s) {
    return s.status_text == "no eye tracker is attached";
  });
  EXPECT_FALSE(state.is_connected);
  // The last sample before stays.
  EXPECT_LT(
      glm::distance(newest(clock.now())->direction, glm::normalize(Vec3(-0.3F, 0.15F, -0.3F))),
      1e-6F);

  is_plugged_in = true;
  test::wait_until("the gaze after it was plugged in again", [&] {
    return glm::distance(newest(clock.now())->direction,
                         glm::normalize(Vec3(0.3F, -0.15F, -0.3F))) < 1e-6F;
  });
}

TEST(HidEyeTracker, SaysWhatIsWrongAndGoesOnTrying) {
  const SteadyClock clock;
  CallLog log;
  enum class Fault { none, may_not_be_read, is_no_tracker };
  std::atomic<Fault> fault = Fault::may_not_be_read;
  const auto open = [&] {
    if (fault == Fault::may_not_be_read) {
      throw Error("/dev/hidraw3", "may not be read", "add a udev rule");
    }
    return std::optional(
        connection_to(std::make_unique<ScriptedDevice>(Reads{}, log),
                      fault == Fault::none ? test::reference_descriptor() : from_hex("a1 01")));
  };
  const auto says = [](const std::string& text) {
    return [text](const HidTrackerState& state) {
      return !state.is_connected && state.status_text.find(text) != std::string::npos;
    };
  };
  HidEyeTracker tracker(open, clock, quick_settings());
  wait_for(tracker, says("add a udev rule"));
  fault = Fault::is_no_tracker;
  wait_for(tracker, says("a collection has no end"));
  fault = Fault::none;
  EXPECT_EQ(wait_for(tracker, is_connected).status_text, "");
}

/// Has none of the features that it describes.
class StubbornDevice final : public ScriptedDevice {
 public:
  using ScriptedDevice::ScriptedDevice;
  std::optional<Bytes> get_feature_report(std::uint8_t /*id*/, std::size_t /*size*/) override {
    return std::nullopt;
  }
  bool send_feature_report(std::uint8_t /*id*/, std::span<const std::uint8_t> /*report*/) override {
    return false;
  }
};

TEST(HidEyeTracker, ReadsADeviceThatAnswersNothing) {
  const SteadyClock clock;
  CallLog log;
  const auto open = [&] {
    return std::optional(connection_to(
        std::make_unique<StubbornDevice>(Reads{tracking_report(5, 500'000, 500'000)}, log)));
  };
  HidEyeTracker tracker(open, clock, quick_settings());
  NewestGaze newest(tracker);
  test::wait_until("a gaze", [&] { return newest(clock.now()).has_value(); });
  const HidTrackerState state = tracker.state();
  EXPECT_THAT(state.status_text, HasSubstr("refuses to be asked for gaze"));
  EXPECT_FALSE(state.configuration);
  EXPECT_LT(glm::distance(newest(clock.now())->direction, Vec3(0, 0, -1)), 1e-6F);
}

// If it did not, the test would last for an hour.
TEST(HidEyeTracker, EndsWhileItWaitsForTheDevice) {
  const SteadyClock clock;
  HidTrackerSettings settings = quick_settings();
  settings.retry = std::chrono::hours(1);
  HidEyeTracker tracker([] { return std::optional<HidConnection>(); }, clock, settings);
  wait_for(tracker, [](const HidTrackerState& state) { return !state.status_text.empty(); });
}

/// Sends as fast as it is read, for ever.
class EndlessDevice final : public ScriptedDevice {
 public:
  using ScriptedDevice::ScriptedDevice;
  std::optional<std::size_t> read(std::span<std::uint8_t> buffer,
                                  milliseconds /*timeout*/) override {
    const Bytes report = tracking_report(time_us_ += 10, 0, 0);
    std::copy(report.begin(), report.end(), buffer.begin());
    return report.size();
  }

 private:
  std::uint64_t time_us_ = 0;
};

TEST(HidEyeTracker, IsPolledAndEndsWhileReportsPourIn) {
  const SteadyClock clock;
  CallLog log;
  const auto open = [&] {
    return std::optional(connection_to(std::make_unique<EndlessDevice>(Reads{}, log)));
  };
  HidEyeTracker tracker(open, clock, quick_settings());
  NewestGaze newest(tracker);
  test::wait_until("a gaze", [&] { return newest(clock.now()).has_value(); });
  Nanoseconds last(0);
  for (int i = 0; i < 1000; ++i) {
    const auto sample = newest(clock.now());
    ASSERT_TRUE(sample && sample->valid);
    ASSERT_GE(sample->time, last);
    last = sample->time;
  }
}

}  // namespace
}  // namespace foveola
