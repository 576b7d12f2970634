#include "renderer/gaze/hid/hid_device.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>

#include <hidapi.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/gaze/hid/hid_eye_reports.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// hidapi stores its last error for all devices in one place, which enumerating and opening write:
/// only one thread may do so at a time.
std::unique_lock<std::mutex> hidapi_lock() {
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

/// hidapi decodes strings by the locale, which is "C" unless the program sets another: only ASCII
/// is decoded in any case.
std::string ascii(const wchar_t* text) {
  std::string result;
  for (; text != nullptr && *text != L'\0'; ++text) {
    result += *text < 128 ? static_cast<char>(*text) : '?';
  }
  return result;
}

HidDeviceInfo info_from(const hid_device_info& device) {
  return {.path = device.path,
          .vendor_id = device.vendor_id,
          .product_id = device.product_id,
          .manufacturer = ascii(device.manufacturer_string),
          .product = ascii(device.product_string),
          .serial_number = ascii(device.serial_number)};
}

/// hidapi 0.13 has no function for it; the kernel provides it beside the device.
std::vector<std::uint8_t> report_descriptor_of(const std::string& device_path) {
  const fs::path name = fs::path(device_path).filename();
  const std::string bytes =
      read_file(fs::path("/sys/class/hidraw") / name / "device" / "report_descriptor");
  return {bytes.begin(), bytes.end()};
}

class HidapiDevice final : public HidDevice {
 public:
  explicit HidapiDevice(hid_device* device) : device_(device) {}

  std::optional<std::size_t> read(std::span<std::uint8_t> buffer,
                                  std::chrono::milliseconds timeout) override {
    errno = 0;
    const int size = hid_read_timeout(device_.get(), buffer.data(), buffer.size(),
                                      static_cast<int>(timeout.count()));
    if (size >= 0) {
      return static_cast<std::size_t>(size);
    }
    // A signal in this thread is not a reason to give the device up.
    return errno == EINTR ? std::optional<std::size_t>(0) : std::nullopt;
  }

  std::optional<std::vector<std::uint8_t>> get_feature_report(std::uint8_t id,
                                                              std::size_t size_bytes) override {
    std::vector<std::uint8_t> bytes(size_bytes + unsent_bytes(id), 0);
    bytes.front() = id;
    const int size = hid_get_feature_report(device_.get(), bytes.data(), bytes.size());
    if (size < static_cast<int>(unsent_bytes(id))) {
      return std::nullopt;
    }
    bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(size)));
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(unsent_bytes(id)));
    return bytes;
  }

  bool send_feature_report(std::uint8_t id, std::span<const std::uint8_t> report) override {
    std::vector<std::uint8_t> bytes(unsent_bytes(id), 0);
    bytes.insert(bytes.end(), report.begin(), report.end());
    return hid_send_feature_report(device_.get(), bytes.data(), bytes.size()) >= 0;
  }

 private:
  /// To hidapi every feature report begins with an id, which is 0 and not sent if there are none.
  static std::size_t unsent_bytes(std::uint8_t id) { return id == 0 ? 1 : 0; }

  struct Close {
    void operator()(hid_device* device) const { hid_close(device); }
  };
  std::unique_ptr<hid_device, Close> device_;
};

}  // namespace

std::vector<HidDeviceInfo> list_hid_eye_trackers() {
  const auto lock = hidapi_lock();
  struct Free {
    void operator()(hid_device_info* devices) const { hid_free_enumeration(devices); }
  };
  const std::unique_ptr<hid_device_info, Free> devices(hid_enumerate(0, 0));
  std::vector<HidDeviceInfo> trackers;
  for (const hid_device_info* device = devices.get(); device != nullptr; device = device->next) {
    const bool is_tracker = device->usage_page == eye_and_head_trackers_page &&
                            device->usage == eye_tracker_usage && device->path != nullptr;
    // A device is listed once per collection.
    const auto has_its_path = [&](const HidDeviceInfo& info) { return info.path == device->path; };
    if (is_tracker && std::ranges::none_of(trackers, has_its_path)) {
      trackers.push_back(info_from(*device));
    }
  }
  return trackers;
}

bool is_chosen(const HidDeviceInfo& device, const HidDeviceChoice& choice) {
  return choice.vendor_id.value_or(device.vendor_id) == device.vendor_id &&
         choice.product_id.value_or(device.product_id) == device.product_id &&
         choice.serial_number.value_or(device.serial_number) == device.serial_number;
}

HidConnection open_hid_device(const HidDeviceInfo& info) {
  HidConnection connection{.info = info, .report_descriptor = report_descriptor_of(info.path)};
  const auto lock = hidapi_lock();
  hid_device* device = hid_open_path(info.path.c_str());
  if (device == nullptr) {
    throw Error(info.path, ascii(hid_error(nullptr)),
                "check that the tracker is plugged in and that a udev rule lets you read and "
                "write its hidraw device");
  }
  connection.device = std::make_unique<HidapiDevice>(device);
  return connection;
}

std::optional<HidConnection> open_hid_eye_tracker(const HidDeviceChoice& choice) {
  const std::vector<HidDeviceInfo> trackers = list_hid_eye_trackers();
  const auto chosen = std::ranges::find_if(
      trackers, [&](const HidDeviceInfo& tracker) { return is_chosen(tracker, choice); });
  return chosen != trackers.end() ? std::optional(open_hid_device(*chosen)) : std::nullopt;
}

}  // namespace foveola
