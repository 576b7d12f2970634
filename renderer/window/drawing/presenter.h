// What a display is given to draw, frame by frame, the displays' interface, and the thread that
// draws into a window, to which frames are handed over.
#pragma once

#include <condition_variable>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/image/image.h"
#include "renderer/window/drawing/text_overlay.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/drawing/view_overlays.h"
#include "renderer/window/drawing/view_renderer.h"
#include "renderer/window/window.h"

namespace foveola {

/// All that the drawing thread needs for a frame.
struct ShownFrame {
  IVec2 framebuffer{0};  ///< pixels; nothing is drawn if it has none
  /// The film that the graphics card draws, or null: of the same film as before if of its size.
  const PyramidAtlas* atlas = nullptr;
  FilmUpdate update;             ///< since the frame before
  std::vector<ShownView> views;  ///< one, or one for each eye
  double late_turn_rad = 0.0;    ///< the presenter's
  /// What each view shows of a film that the processor resampled, of as many pixels as its part
  /// has; empty if the graphics card resamples it.
  std::vector<const ByteImage*> pictures;
  ViewLook look;
  ViewOverlays overlays;
  std::vector<TextPanel> panels;
  /// Over all else: a part of the window that is white, or black.
  std::optional<WindowPart> patch;
  bool is_patch_lit = false;
  std::optional<ScreenPage> screen;  ///< over the views, or instead of them
  /// Gets what was drawn, sRGB in [0, 1], top row first.
  std::shared_ptr<std::promise<RgbImage>> picture;
  /// Whether that is the film alone, without what stands over it.
  bool picture_is_bare = false;
};

/// Asks for the frame's picture; it is there once the frame is drawn, or throws if it never is.
std::future<RgbImage> picture_of(ShownFrame& frame);

/// Who resamples the film for a frame.
enum class FilmDrawer {
  graphics_card,  ///< keeps a copy of the film's pyramid as a texture and resamples that
  processor       ///< resamples the film itself; OpenGL gets finished pictures
};

/// A display that takes frames one by one, and draws them in a thread of its own.
class Presenter {
 public:
  virtual ~Presenter() = default;

  /// Waits until the frame is drawn, and no longer needs what it refers to; it is shown at the
  /// next refresh, after the one before. Rethrows what went wrong in the drawing thread.
  virtual void draw(ShownFrame frame) = 0;

  /// Waits until the frame that was drawn last is shown, and says when that was: its buffers were
  /// swapped, or it was handed to a headset. Rethrows as draw.
  virtual Nanoseconds wait_until_shown() = 0;

  /// The graphics card and its driver, in their own words.
  virtual const std::string& graphics() const = 0;
  virtual FilmDrawer film_drawer() const = 0;
  /// How far the head may turn until a frame is seen that shows it as it is turned then; 0 where it
  /// is shown as it was when the frame began.
  virtual double late_turn_rad() const { return 0.0; }
  /// What a window of so many pixels, of which it has some, shows of the sphere while it draws
  /// frames of `shown`: where the mouse points there.
  virtual ViewGeometry in_window(const ViewGeometry& shown, const IVec2& /*window_px*/) const {
    return shown;
  }
};

class FrameHandover {
 public:
  // --- The thread that renders. Each rethrows what went wrong in the other one. ---

  /// Waits until frames are taken.
  void wait_until_ready();
  /// Hands a frame over, once the one before was shown, and waits until it is drawn.
  void draw(ShownFrame frame);
  /// Waits until that frame was shown, and says when.
  Nanoseconds wait_until_shown();

  // --- The thread that draws ---

  /// Frames are taken from now on.
  void be_ready();
  /// Waits for a frame; empty if `stop` is requested.
  std::optional<ShownFrame> wait_for_frame(const std::stop_token& stop);
  /// The frame that was handed over, if there is one.
  std::optional<ShownFrame> take_frame();
  /// The frame no longer needs what it refers to.
  void note_drawn();
  /// It was shown at `time`: there may be another.
  void note_shown(Nanoseconds time);
  /// Nothing is taken any longer.
  void fail(std::exception_ptr fault);

 private:
  /// Waits for `flag`, or for what goes wrong instead and rethrows it.
  void wait_for(const bool& flag, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  // Guarded by the mutex:
  bool is_ready_ = false;            ///< ready for a frame: the one before was shown
  bool is_drawn_ = false;            ///< the frame that was handed over last
  std::optional<ShownFrame> frame_;  ///< handed over, not taken yet
  Nanoseconds shown_{0};             ///< when the last one was
  std::exception_ptr fault_;
};

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
