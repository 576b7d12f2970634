#include "renderer/gaze/hid/hid_device.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(HidDeviceChoice, HasToAgreeInAllThatItSays) {
  const HidDeviceInfo device{.vendor_id = 0x1234, .product_id = 0xABCD, .serial_number = "7"};
  EXPECT_TRUE(is_chosen(device, {}));
  EXPECT_TRUE(is_chosen(device, {.vendor_id = 0x1234}));
  EXPECT_TRUE(is_chosen(device, {0x1234, 0xABCD, "7"}));
  EXPECT_FALSE(is_chosen(device, {.vendor_id = 0x1235}));
  EXPECT_FALSE(is_chosen(device, {.vendor_id = 0x1234, .product_id = 0xABCE}));
  EXPECT_FALSE(is_chosen(device, {.serial_number = "8"}));
}

TEST(HidDevice, CannotBeOpenedIfItIsGone) {
  EXPECT_THAT([] { open_hid_device({.path = "/dev/hidraw-that-is-gone"}); },
              ThrowsMessage<Error>(HasSubstr("hidraw-that-is-gone")));
}

}  // namespace
}  // namespace foveola
