#include "renderer/window/timing_patch.h"

namespace foveola {

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
