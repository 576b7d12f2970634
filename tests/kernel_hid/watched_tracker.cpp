#include "tests/kernel_hid/watched_tracker.h"

#include <memory>
#include <span>
#include <utility>

#include "tests/waiting.h"

namespace foveola::test {

/// When the tracker's thread comes for the next report, the sample that it made of the one before
/// is the newest.
class WatchedTracker::WatchedDevice final : public HidDevice {
 public:
  WatchedDevice(std::unique_ptr<HidDevice> device, WatchedTracker& watched)
      : device_(std::move(device)), watched_(&watched) {}

  std::optional<std::size_t> read(std::span<std::uint8_t> buffer,
                                  std::chrono::milliseconds timeout) override {
    watched_->keep_arrived();
    return device_->read(buffer, timeout);
  }

  std::optional<std::vector<std::uint8_t>> get_feature_report(std::uint8_t id,
                                                              std::size_t size_bytes) override {
    return device_->get_feature_report(id, size_bytes);
  }

  bool send_feature_report(std::uint8_t id, std::span<const std::uint8_t> report) override {
    return device_->send_feature_report(id, report);
  }

 private:
  std::unique_ptr<HidDevice> device_;
  WatchedTracker* watched_;
};

WatchedTracker::WatchedTracker(std::uint16_t product_id, const HidTrackerSettings& settings)
    : tracker_([this, product_id] { return open(product_id); }, clock_, settings) {
  is_made_.count_down();
}

HidTrackerState WatchedTracker::wait_for(
    const std::string& what, const std::function<bool(const HidTrackerState&)>& is_reached) const {
  HidTrackerState reached;
  wait_until(what, [&] {
    reached = state();
    return is_reached(reached);
  });
  return reached;
}

std::vector<GazeSample> WatchedTracker::wait_for_samples(std::size_t count) const {
  std::vector<GazeSample> samples;
  wait_until(std::to_string(count) + " samples", [&] {
    const std::lock_guard lock(mutex_);
    samples = samples_;
    return samples.size() >= count;
  });
  return samples;
}

std::optional<HidConnection> WatchedTracker::open(std::uint16_t product_id) {
  is_made_.wait();
  std::optional<HidConnection> connection = open_hid_eye_tracker({.product_id = product_id});
  if (connection) {
    connection->device = std::make_unique<WatchedDevice>(std::move(connection->device), *this);
  }
  return connection;
}

void WatchedTracker::keep_arrived() {
  const std::lock_guard lock(mutex_);
  tracker_.poll(clock_.now(), samples_);
}

}  // namespace foveola::test
