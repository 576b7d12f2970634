#include "renderer/scene/textures/srgb.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// Values that IEC 61966-2-1 and its common tables give.
TEST(Srgb, DecodesKnownCodes) {
  EXPECT_EQ(linear_from_byte(true)[0], 0.0F);
  EXPECT_NEAR(linear_from_byte(true)[10], 0.00303527F, 1e-8F);
  EXPECT_NEAR(linear_from_byte(true)[128], 0.21586050F, 1e-7F);
  EXPECT_NEAR(linear_from_byte(true)[188], 0.50288646F, 1e-7F);
  EXPECT_EQ(linear_from_byte(true)[255], 1.0F);
  EXPECT_EQ(linear_from_byte(false)[51], 0.2F);
}

TEST(Srgb, EncodesWhatItDecoded) {
  for (int code = 0; code < 256; ++code) {
    EXPECT_EQ(srgb_byte_from_linear(linear_from_byte(true)[static_cast<std::size_t>(code)]), code);
  }
}

/// The standard's own encoding, rounded, on a fine grid; at a border either neighbour will do.
TEST(Srgb, EncodesToTheNearestCode) {
  for (int i = 0; i <= 200000; ++i) {
    const double linear = i / 200000.0;
    const double exact =
        255.0 *
        (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
    EXPECT_NEAR(srgb_byte_from_linear(static_cast<float>(linear)), exact, 0.501) << linear;
  }
  EXPECT_EQ(srgb_byte_from_linear(-1.0F), 0);
  EXPECT_EQ(srgb_byte_from_linear(7.0F), 255);
}

}  // namespace
}  // namespace foveola
