// hidapi, udev and the device files, on an eye tracker that umockdev mocks.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/renderer/gaze/hid_reference.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using test::Bytes;
using test::to_hex;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int reports = 240;  // two seconds of a tracker of 120 Hz

Bytes report(int index) {
  return test::tracking_report(8333 * static_cast<std::uint64_t>(index), 1000 * index, -index);
}

/// As umockdev-record would have written it: a USB device of the standard's descriptor.
std::string device_description() {
  const std::string hid = "/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1234:ABCD.0001";
  return "P: " + hid +
         "/hidraw/hidraw0\n"
         "N: hidraw0\n"
         "E: DEVNAME=/dev/hidraw0\n"
         "E: MAJOR=240\n"
         "E: MINOR=0\n"
         "E: SUBSYSTEM=hidraw\n"
         "A: dev=240:0\\n\n"
         "L: device=../../../0003:1234:ABCD.0001\n"
         "\n"
         "P: " +
         hid +
         "\n"
         "E: DRIVER=hid-generic\n"
         "E: HID_ID=0003:00001234:0000ABCD\n"
         "E: HID_NAME=Reference Eye Tracker\n"
         "E: HID_PHYS=usb-1/input0\n"
         "E: HID_UNIQ=42\n"
         "E: SUBSYSTEM=hid\n"
         "H: report_descriptor=" +
         to_hex(test::reference_descriptor()) + "\n";
}

std::string ioctls() {
  const auto call = [](const std::string& name, std::size_t result, const Bytes& data) {
    return name + " " + std::to_string(result) + " " + to_hex(data) + "\n";
  };
  const Bytes configuration = test::configuration_report(600'000, 300'000);
  const Bytes capabilities = test::capabilities_report();
  const Bytes status = test::status_report(1, 120);
  return "@DEV /dev/hidraw0\n" + call("HIDIOCGRDESCSIZE", 0, test::little_endian(340, 4)) +
         call("HIDIOCGFEATURE", configuration.size(), configuration) +
         call("HIDIOCGFEATURE", capabilities.size(), capabilities) +
         call("HIDIOCGFEATURE", status.size(), status) +
         call("HIDIOCSFEATURE", 2, test::from_hex("1401"));
}

/// All reports, 4 ms apart. (umockdev's script-format.txt tells how bytes are escaped, but
/// a blank is not.)
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
    folder_.write("device", device_description());
    folder_.write("ioctls", ioctls());
    folder_.write("script", script());
  }

  /// What the client prints in the mock's surroundings.
  std::string output_of_client(const std::string& arguments) const {
    const std::string folder = folder_.path().string();
    return output_of("umockdev-run -d " + folder + "/device -i /dev/hidraw0=" + folder +
                     "/ioctls -s /dev/hidraw0=" + folder + "/script -- " + HID_UMOCKDEV_CLIENT +
                     " " + arguments + " 2>&1");
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(MockedTracker, IsListedOnceAndReadWhole) {
  std::string expected = "device /dev/hidraw0 1234 ABCD Reference Eye Tracker\n";
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
