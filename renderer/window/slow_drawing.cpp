#include "renderer/window/slow_drawing.h"

#include <fmt/format.h>

namespace foveola {

std::string slow_drawing_line(const SlowDrawing& slow) {
  constexpr double ms_per_s = 1e3;
  return fmt::format(
      "Drawing is too slow for this window: {} takes {:.1f} ms for {}x{} pixels, and the display "
      "refreshes every {:.1f} ms. Every frame is late, and half of it is left to tracing; a "
      "smaller --window or a graphics card helps.",
      slow.graphics, ms_per_s * seconds(slow.drawing), slow.framebuffer.x, slow.framebuffer.y,
      ms_per_s * seconds(slow.interval));
}

}  // namespace foveola
