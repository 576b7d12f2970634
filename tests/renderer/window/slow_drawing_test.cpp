#include "renderer/window/slow_drawing.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(SlowDrawing, SaysWhatIsSlowAndWhatHelps) {
  const SlowDrawing slow{.drawing = std::chrono::microseconds(37'890),
                         .interval = std::chrono::microseconds(16'667),
                         .framebuffer = {1280, 720},
                         .graphics = "llvmpipe (LLVM 15.0.6, 256 bits)"};
  EXPECT_EQ(
      slow_drawing_line(slow),
      "Drawing takes long here: 37.9 ms for 1280x720 pixels (llvmpipe (LLVM 15.0.6, 256 bits)), "
      "where the display refreshes every 16.7 ms. So that most of the time is left for tracing, "
      "frames stay for more than one refresh; smaller pictures or a graphics card make them "
      "faster.");
  EXPECT_EQ(slow_drawing_note(slow), "drawing takes 38 ms here, so frames stay longer");
}

}  // namespace
}  // namespace foveola
