#include "renderer/window/drawing/presenter.h"

#include <utility>

#include "renderer/window/drawing/film_drawing.h"
#include "renderer/window/drawing/frame_painter.h"

namespace foveola {

std::future<RgbImage> picture_of(ShownFrame& frame) {
  frame.picture = std::make_shared<std::promise<RgbImage>>();
  return frame.picture->get_future();
}

void FrameHandover::wait_until_ready() {
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
}

void FrameHandover::draw(ShownFrame frame) {
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
  is_ready_ = false;
  is_drawn_ = false;
  frame_ = std::move(frame);
  changed_.notify_all();
  wait_for(is_drawn_, lock);
}

Nanoseconds FrameHandover::wait_until_shown() {
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
  return shown_;
}

void FrameHandover::wait_for(const bool& flag, std::unique_lock<std::mutex>& lock) {
  changed_.wait(lock, [&] { return flag || fault_; });
  if (fault_) {
    std::rethrow_exception(fault_);
  }
}

void FrameHandover::be_ready() {
  const std::scoped_lock lock(mutex_);
  is_ready_ = true;
  changed_.notify_all();
}

std::optional<ShownFrame> FrameHandover::wait_for_frame(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [this] { return frame_.has_value(); });
  return std::exchange(frame_, std::nullopt);
}

std::optional<ShownFrame> FrameHandover::take_frame() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(frame_, std::nullopt);
}

void FrameHandover::note_drawn() {
  const std::scoped_lock lock(mutex_);
  is_drawn_ = true;
  changed_.notify_all();
}

void FrameHandover::note_shown(Nanoseconds time) {
  const std::scoped_lock lock(mutex_);
  shown_ = time;
  is_ready_ = true;
  changed_.notify_all();
}

void FrameHandover::fail(std::exception_ptr fault) {
  const std::scoped_lock lock(mutex_);
  fault_ = std::move(fault);
  changed_.notify_all();
}

WindowPresenter::WindowPresenter(Window& window, const IVec2& framebuffer, const Clock& clock)
    : window_(&window), clock_(&clock) {
  thread_ =
      std::jthread([this, framebuffer](const std::stop_token& stop) { run(framebuffer, stop); });
  handover_.wait_until_ready();
}

WindowPresenter::~WindowPresenter() = default;

FilmDrawer WindowPresenter::film_drawer() const { return default_drawer(graphics_); }

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
