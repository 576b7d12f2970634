// The thread that draws into a window, and shows each frame at its display's next refresh.
#pragma once

#include <thread>

#include "renderer/window/frame_handover.h"
#include "renderer/window/window.h"

namespace foveola {

class WindowPresenter final : public Presenter {
 public:
  /// Takes the window's context. window and clock must outlive it. framebuffer: the window's size
  /// in pixels. Throws Error if the graphics card cannot draw into such a window.
  WindowPresenter(Window& window, const IVec2& framebuffer, const Clock& clock);
  ~WindowPresenter() override;
  WindowPresenter(const WindowPresenter&) = delete;
  WindowPresenter& operator=(const WindowPresenter&) = delete;

  void draw(ShownFrame frame) override { handover_.draw(std::move(frame)); }
  Nanoseconds wait_until_shown() override { return handover_.wait_until_shown(); }
  const std::string& graphics() const override { return graphics_; }
  FilmDrawer film_drawer() const override;

 private:
  void run(const IVec2& framebuffer, const std::stop_token& stop);

  Window* window_;
  const Clock* clock_;
  std::string graphics_;
  FrameHandover handover_;
  std::jthread thread_;  ///< last: it ends before the rest does
};

}  // namespace foveola
