// hidapi, udev and the device files, on an eye tracker that umockdev mocks.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/renderer/gaze/hid_reference.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using test::Bytes;
using test::operator+;
using test::to_hex;

constexpr int reports = 240;  // two seconds of a tracker of 120 Hz

Bytes report(int index) {
  return test::tracking_report(8333 * static_cast<std::uint64_t>(index), 1000 * index, -index);
}

/// As umockdev-record would have written it: the USB device number `index` with its hidraw device.
std::string device_description(int index, const std::string& name, const Bytes& descriptor) {
  const std::string number = std::to_string(index);
  const std::string hid = "0003:1234:ABC" + number + ".000" + number;
  const std::string path = "/devices/pci0000:00/usb1/1-1/1-1:1.0/" + hid;
  const std::vector<std::string> lines = {"P: " + path + "/hidraw/hidraw" + number,
                                          "N: hidraw" + number,
                                          "E: DEVNAME=/dev/hidraw" + number,
                                          "E: MAJOR=240",
                                          "E: MINOR=" + number,
                                          "E: SUBSYSTEM=hidraw",
                                          "A: dev=240:" + number + "\\n",
                                          "L: device=../../../" + hid,
                                          "",
                                          "P: " + path,
                                          "E: DRIVER=hid-generic",
                                          "E: HID_ID=0003:00001234:0000ABC" + number,
                                          "E: HID_NAME=" + name,
                                          "E: HID_PHYS=usb-1/input" + number,
                                          "E: HID_UNIQ=4" + number,
                                          "E: SUBSYSTEM=hid",
                                          "H: report_descriptor=" + to_hex(descriptor),
                                          ""};
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

/// The reference device, a mouse, and a device with two eye trackers in it.
std::string device_descriptions() {
  // Within it is a pointer, usage 1 on another page.
  const Bytes mouse =
      test::from_hex("05 01 09 02 a1 01 09 01 a1 00 09 30 09 31 75 08 95 02 81 06 c0 c0");
  const Bytes tracker = test::from_hex("05 12 09 01 a1 01 09 10 a1 02 c0 c0");
  return device_description(0, "Reference Eye Tracker", test::reference_descriptor()) +
         device_description(1, "Mouse", mouse) + device_description(2, "Twice", tracker + tracker);
}

std::string ioctls() {
  const auto call = [](const std::string& name, std::size_t result, const Bytes& data) {
    return name + " " + std::to_string(result) + " " + to_hex(data) + "\n";
  };
  const Bytes configuration = test::configuration_report(600'000, 300'000);
  const Bytes status = test::status_report(1, 120);
  return "@DEV /dev/hidraw0\n" + call("HIDIOCGRDESCSIZE", 0, test::little_endian(340, 4)) +
         call("HIDIOCGFEATURE", configuration.size(), configuration) +
         call("HIDIOCGFEATURE", status.size(), status) +
         call("HIDIOCSFEATURE", 2, test::from_hex("1401"));
}

/// All reports, 4 ms apart, from 300 ms on. umockdev's script-format.txt says how bytes are
/// escaped; in truth a blank is not.
std::string script() {
  std::string text;
  for (int i = 0; i < reports; ++i) {
    text += i == 0 ? "r 300 " : "r 4 ";
    for (const std::uint8_t byte : report(i)) {
      if (byte < ' ') {
        text += {'^', static_cast<char>(byte + 64)};
      } else if (byte == '^') {
        text += "^`";
      } else {
        text += static_cast<char>(byte);
      }
    }
    text += '\n';
  }
  return text;
}

std::string output_of(const std::string& command) {
  std::string output;
  FILE* pipe = ::popen(command.c_str(), "r");
  for (int c = pipe != nullptr ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe)) {
    output += static_cast<char>(c);
  }
  if (pipe != nullptr) {
    ::pclose(pipe);
  }
  return output;
}

class MockedTracker : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v umockdev-run >/dev/null") != 0) {
      GTEST_SKIP() << "umockdev-run is not installed (Debian package umockdev)";
    }
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);  // umockdev plays devices on one
    if (terminal < 0) {
      GTEST_SKIP() << "there are no pseudo-terminals here (/dev/pts is not mounted)";
    }
    ::close(terminal);
    folder_.write("devices", device_descriptions());
    folder_.write("ioctls", ioctls());
    folder_.write("script", script());
  }

  /// What the client prints in the mock's surroundings, errors included. At its end umockdev 0.19
  /// complains of the devices that it takes away itself.
  std::string output_of_client(const std::string& arguments) const {
    const std::string folder = folder_.path().string();
    return output_of("umockdev-run -d " + folder + "/devices -i /dev/hidraw0=" + folder +
                     "/ioctls -s /dev/hidraw0=" + folder + "/script -- sh -c '" +
                     HID_UMOCKDEV_CLIENT + " " + arguments + " 2>&1'");
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(MockedTracker, IsListedOnceAmongOthersAndReadWhole) {
  std::string expected = "device /dev/hidraw0 1234 ABC0 Reference Eye Tracker\n";
  expected += "device /dev/hidraw2 1234 ABC2 Twice\n";
  expected += "descriptor " + to_hex(test::reference_descriptor()) + "\n";
  expected += "configuration " + to_hex(test::configuration_report(600'000, 300'000)) + "\n";
  expected += "status " + to_hex(test::status_report(1, 120)) + "\n";
  expected += "mode taken\n";
  for (int i = 0; i < reports; ++i) {
    expected += "report " + to_hex(report(i)) + "\n";
  }
  EXPECT_EQ(output_of_client("read " + std::to_string(reports)), expected);
}

TEST_F(MockedTracker, TheReaderThreadMissesNothing) {
  EXPECT_EQ(output_of_client("track " + std::to_string(reports)), "tracked 240 wrong 0 short 0\n");
}

}  // namespace
}  // namespace foveola
