#include "renderer/headset/headset_mirror.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>

#include "renderer/headset/glx_session.h"

namespace foveola {

WindowPart largest_part(const IVec2& window, const IVec2& picture) {
  const double scale = std::min(static_cast<double>(window.x) / picture.x,
                                static_cast<double>(window.y) / picture.y);
  const IVec2 size(std::lround(scale * picture.x), std::lround(scale * picture.y));
  return {.origin = (window - size) / 2, .size = size};
}

void HeadsetMirror::begin_frame(Nanoseconds now) {
  is_due_ = now >= next_;
  if (is_due_) {
    next_ = now + interval;
  }
}

void HeadsetMirror::copy(const ShownView& view) {
  if (!is_due_) {
    return;
  }
  window_px_ = current_drawable_px();
  const WindowPart to = largest_part(window_px_, view.part.size);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glBlitFramebuffer(0, 0, view.part.size.x, view.part.size.y, to.origin.x, to.origin.y,
                    to.origin.x + to.size.x, to.origin.y + to.size.y, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  copied_ = {.viewport = view.viewport, .part = to};
}

void HeadsetMirror::show(const std::optional<Vec3>& gaze, std::span<const TextPanel> panels,
                         FramePainter& painter) {
  const std::optional<ShownView> view = std::exchange(copied_, std::nullopt);
  if (!view) {
    return;
  }
  glViewport(0, 0, window_px_.x, window_px_.y);
  ShownFrame over;
  if (gaze) {
    over.overlays.gaze = *gaze;
    over.overlays.shows_gaze = true;
  }
  painter.draw_over(over, window_px_, {&*view, 1}, panels);
  window_->swap();
}

}  // namespace foveola
