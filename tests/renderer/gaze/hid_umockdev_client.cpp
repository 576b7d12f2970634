// Talks to the eye tracker that is attached and prints what it said, for hid_umockdev_test, which
// runs this where umockdev mocks one.
//   hid_umockdev_client read N    the device and its features, then N reads of the length of a
//                                 tracking report, in hexadecimal digits
//   hid_umockdev_client track N   the counters once the reader thread has taken N tracking reports
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "renderer/gaze/hid_device.h"
#include "renderer/gaze/hid_eye_reports.h"
#include "renderer/gaze/hid_eye_tracker.h"

namespace foveola {
namespace {

/// How long to wait for what should come at once, on a machine that does much else.
constexpr std::chrono::seconds patience{60};

void print(std::string_view name, std::span<const std::uint8_t> bytes) {
  std::printf("%.*s ", static_cast<int>(name.size()), name.data());
  for (const std::uint8_t byte : bytes) {
    std::printf("%02X", static_cast<unsigned>(byte));
  }
  std::printf("\n");
}

void print_feature(HidDevice& device, std::string_view name, const HidReportShape& shape) {
  if (const auto report = device.get_feature_report(shape.id, shape.size_bytes)) {
    print(name, *report);
  }
}

int read(int reports) {
  for (const HidDeviceInfo& info : list_hid_eye_trackers()) {
    std::printf("device %s %04X %04X %s\n", info.path.c_str(),
                static_cast<unsigned>(info.vendor_id), static_cast<unsigned>(info.product_id),
                info.product.c_str());
  }
  const std::optional<HidConnection> connection = open_hid_eye_tracker();
  if (!connection) {
    return 1;
  }
  HidDevice& device = *connection->device;
  print("descriptor", connection->report_descriptor);
  const HidEyeReports layout =
      find_eye_reports(parse_report_descriptor(connection->report_descriptor));
  print_feature(device, "configuration", layout.configuration->shape);
  print_feature(device, "status", layout.status_feature->shape);
  const bool is_taken =
      device.send_feature_report(layout.control->shape.id, encode_gaze_request(*layout.control));
  std::printf("mode %s\n", is_taken ? "taken" : "refused");
  std::vector<std::uint8_t> buffer(layout.tracking.shape.size_bytes);
  for (int i = 0; i < reports; ++i) {
    const auto size_bytes = device.read(buffer, patience);
    if (!size_bytes || *size_bytes == 0) {
      return 1;
    }
    print("report", std::span(buffer).first(*size_bytes));
  }
  return 0;
}

int track(std::uint64_t reports) {
  const SteadyClock clock;
  const HidEyeTracker tracker([] { return open_hid_eye_tracker(); }, clock, {});
  HidGazeCounters counters;
  for (const Nanoseconds end = clock.now() + patience;
       counters.reports < reports && clock.now() < end;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    counters = tracker.state().counters;
  }
  std::printf("tracked %d wrong %d short %d\n", static_cast<int>(counters.reports),
              static_cast<int>(counters.wrong_ids), static_cast<int>(counters.short_reads));
  return 0;
}

}  // namespace
}  // namespace foveola

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv, argv + argc);
    const int reports = std::stoi(arguments.at(2));
    return arguments.at(1) == "read" ? foveola::read(reports)
                                     : foveola::track(static_cast<std::uint64_t>(reports));
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
