#include "renderer/window/drawing/slow_drawing.h"

#include <fmt/format.h>

namespace foveola {

std::string slow_drawing_line(const SlowDrawing& slow) {
  constexpr double ms_per_s = 1e3;
  return fmt::format(
      "Drawing takes long here: {:.1f} ms for {}x{} pixels ({}), where the display "
      "refreshes every {:.1f} ms. So that most of the time is left for tracing, frames stay for "
      "more than one refresh; smaller pictures or a graphics card make them faster.",
      ms_per_s * seconds(slow.drawing), slow.framebuffer.x, slow.framebuffer.y, slow.graphics,
      ms_per_s * seconds(slow.interval));
}

std::string slow_drawing_note(const SlowDrawing& slow) {
  return fmt::format("drawing takes {:.0f} ms here, so frames stay longer",
                     1e3 * seconds(slow.drawing));
}

WindowPart part_of(const TimingPatch& patch, const IVec2& framebuffer) {
  const IVec2 size = glm::min(IVec2(patch.size_px), framebuffer);
  const bool is_right =
      patch.corner == WindowCorner::top_right || patch.corner == WindowCorner::bottom_right;
  const bool is_top =
      patch.corner == WindowCorner::top_left || patch.corner == WindowCorner::top_right;
  return {.origin = {is_right ? framebuffer.x - size.x : 0, is_top ? framebuffer.y - size.y : 0},
          .size = size};
}

}  // namespace foveola
