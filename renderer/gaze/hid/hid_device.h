// HID devices: enumeration, and reading and writing reports.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foveola {

/// An open device. A report's bytes begin with its id if the device's reports have ids.
class HidDevice {
 public:
  virtual ~HidDevice() = default;

  /// Waits for the next input report and writes it to the beginning of `buffer`. Returns its length
  /// in bytes, at most the buffer's; 0 if none came within `timeout`; nullopt once the device is
  /// gone.
  virtual std::optional<std::size_t> read(std::span<std::uint8_t> buffer,
                                          std::chrono::milliseconds timeout) = 0;

  /// The feature report with this id (0: without ids), at most size_bytes long. nullopt if the
  /// device does not provide it.
  virtual std::optional<std::vector<std::uint8_t>> get_feature_report(std::uint8_t id,
                                                                      std::size_t size_bytes) = 0;

  /// Returns whether the device accepted it. id: as above.
  virtual bool send_feature_report(std::uint8_t id, std::span<const std::uint8_t> report) = 0;
};

struct HidDeviceInfo {
  std::string path;  ///< path of its device file; may change when it is plugged in again
  std::uint16_t vendor_id = 0;
  std::uint16_t product_id = 0;
  std::string manufacturer;
  std::string product;
  std::string serial_number;  ///< empty if absent
};

/// The attached devices with an eye tracker among their collections, each once.
std::vector<HidDeviceInfo> list_hid_eye_trackers();

/// Criteria for a device; empty members match any value.
struct HidDeviceChoice {
  std::optional<std::uint16_t> vendor_id;
  std::optional<std::uint16_t> product_id;
  std::optional<std::string> serial_number;
};

bool is_chosen(const HidDeviceInfo& device, const HidDeviceChoice& choice);

/// A device with its report descriptor.
struct HidConnection {
  HidDeviceInfo info;
  std::vector<std::uint8_t> report_descriptor;
  std::unique_ptr<HidDevice> device;
};

/// Throws Error if the device is gone, or the user lacks permission to read and write it.
HidConnection open_hid_device(const HidDeviceInfo& info);

/// Opens the first attached eye tracker that matches the choice; nullopt if there is none. Throws
/// Error as above.
std::optional<HidConnection> open_hid_eye_tracker(const HidDeviceChoice& choice = {});

}  // namespace foveola
