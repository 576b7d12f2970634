#include "renderer/window/window_presenter.h"

#include "renderer/window/film_drawing.h"
#include "renderer/window/frame_painter.h"

namespace foveola {

WindowPresenter::WindowPresenter(Window& window, const IVec2& framebuffer, const Clock& clock)
    : window_(&window), clock_(&clock) {
  thread_ =
      std::jthread([this, framebuffer](const std::stop_token& stop) { run(framebuffer, stop); });
  handover_.wait_until_ready();
}

WindowPresenter::~WindowPresenter() = default;

FilmDrawer WindowPresenter::film_drawer() const { return usual_drawer(graphics_); }

void WindowPresenter::run(const IVec2& framebuffer, const std::stop_token& stop) {
  try {
    window_->make_current();
    require_drawable(framebuffer);
    FramePainter painter;
    graphics_ = graphics_name();
    handover_.be_ready();
    while (const std::optional<ShownFrame> frame = handover_.wait_for_frame(stop)) {
      painter.draw(*frame);
      glFinish();
      handover_.note_drawn();
      if (frame->framebuffer.x > 0 && frame->framebuffer.y > 0) {
        window_->swap();
      }
      handover_.note_shown(clock_->now());
    }
  } catch (...) {
    handover_.fail(std::current_exception());
  }
  window_->release();
}

}  // namespace foveola
