// HID devices that this program plays to the kernel through /dev/uhid (the kernel's
// Documentation/hid/uhid.rst). Whoever reads one cannot tell it from one that is plugged in.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <linux/uhid.h>

#include "tests/renderer/gaze/hid_reference.h"

namespace foveola::test {

struct UhidSettings {
  std::uint16_t vendor_id = 0;
  std::uint16_t product_id = 0;
  std::string name;           ///< at most 127 characters
  std::string serial_number;  ///< at most 63 characters
  Bytes report_descriptor;    ///< at most 4096 bytes
  /// What the device says if it is asked for the feature report of an id: of an empty one nothing,
  /// so that the kernel has to give up; of one that is not here, that it has none.
  std::map<std::uint8_t, Bytes> features;
};

/// Plugged in while it lives. A thread of its own answers what the kernel asks.
class UhidDevice {
 public:
  /// Throws std::system_error if the kernel has no uhid or the user may not use it. The kernel
  /// makes the device in its own time, and says nothing if it refuses the descriptor.
  explicit UhidDevice(const UhidSettings& settings);
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;

  /// Sends the bytes as one input report: at most 4096, whatever the descriptor says of them.
  void send(const Bytes& report) const;

  /// The feature reports that it was asked for and sent, in order: "get 12", "set 1401".
  std::vector<std::string> requests() const;

  /// Waits until there has been such a request; throws if there never is.
  void wait_for_request(const std::string& request) const;

 private:
  /// Closing it unplugs the device.
  class File {
   public:
    explicit File(const char* path);
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    void write(const uhid_event& event) const;
    /// Waits a moment for the next event and returns whether there was one.
    bool read(uhid_event& event) const;

   private:
    int number_;
  };

  void answer_requests(const std::stop_token& stop);
  void answer_get(const uhid_get_report_req& request);
  void answer_set(const uhid_set_report_req& request);
  void note(const std::string& request);

  std::map<std::uint8_t, Bytes> features_;
  mutable std::mutex mutex_;  ///< of the next
  std::vector<std::string> requests_;
  File file_{"/dev/uhid"};
  std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace foveola::test
