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
      "Drawing is too slow for this window: llvmpipe (LLVM 15.0.6, 256 bits) takes 37.9 ms "
      "for 1280x720 pixels, and the display refreshes every 16.7 ms. Every frame is late, and "
      "half of it is left to tracing; a smaller --window or a graphics card helps.");
}

}  // namespace
}  // namespace foveola
