#include "study/protocol/scaled_protocol.h"

#include <limits>

#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace foveola::study {
namespace {

Protocol large_protocol() {
  Protocol protocol;
  protocol.film = {.width = 4096, .height = 2048};
  protocol.display.view_width = 1280;
  protocol.display.view_height = 1440;
  protocol.machine.samples_per_second = 7e6;
  protocol.cells[{"hall", "od"}] = {.film = {.width = 2048, .height = 1024}};
  return protocol;
}

TEST(ScaledProtocol, HasSoManyTimesFewerPixelsAndSamples) {
  const Protocol scaled = scaled_protocol(large_protocol(), 16.0);
  EXPECT_EQ(scaled.film.width, 1024);
  EXPECT_EQ(scaled.film.height, 512);
  EXPECT_EQ(scaled.display.view_width, 320);
  EXPECT_EQ(scaled.display.view_height, 360);
  EXPECT_DOUBLE_EQ(scaled.machine.samples_per_second, 437'500.0);
  EXPECT_EQ(scaled.cells.at({"hall", "od"}).film.width, 512);
  EXPECT_EQ(scaled.machine.frame_rate_hz, large_protocol().machine.frame_rate_hz);
}

TEST(ScaledProtocol, APixelGetsAsManySamplesASecond) {
  const auto per_pixel = [](const Protocol& protocol) {
    return protocol.machine.samples_per_second / (protocol.film.width * protocol.film.height);
  };
  EXPECT_NEAR(per_pixel(scaled_protocol(large_protocol(), 7.3)), per_pixel(large_protocol()), 1e-9)
      << "whatever the sides were rounded to";
}

TEST(ScaledProtocol, RefusesWhatShowsNothing) {
  EXPECT_THROW(scaled_protocol(large_protocol(), 0.5), UsageError);
  EXPECT_THROW(scaled_protocol(large_protocol(), std::numeric_limits<double>::quiet_NaN()),
               UsageError);
  EXPECT_THROW(scaled_protocol(large_protocol(), 1e6), UsageError);
  EXPECT_THROW(scaled_protocol(large_protocol(), 30000.0), UsageError) << "24 x 12 pixels are left";
}

}  // namespace
}  // namespace foveola::study
