// A display's frames, the displays' interface, and the thread that draws into a window with its
// handover of frames.
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

/// Everything that the drawing thread needs for a frame.
struct ShownFrame {
  IVec2 framebuffer{0};  ///< pixels; if 0, nothing is drawn
  /// The film for the graphics card, or null: the same film as before if of the same size.
  const PyramidAtlas* atlas = nullptr;
  FilmUpdate update;             ///< since the last frame
  std::vector<ShownView> views;  ///< one, or one per eye
  double late_turn_rad = 0.0;    ///< of the presenter
  /// Each view's picture of a film that the processor resampled, of its part's size; empty if the
  /// graphics card resamples it.
  std::vector<const ByteImage*> pictures;
  ViewLook look;
  ViewOverlays overlays;
  std::vector<TextPanel> panels;
  /// Above everything: a white or black part of the window.
  std::optional<WindowPart> patch;
  bool is_patch_lit = false;
  std::optional<ScreenPage> screen;  ///< over the views, or instead of them
  /// Receives the drawn picture, sRGB in [0, 1], top row first.
  std::shared_ptr<std::promise<RgbImage>> picture;
  /// Whether the picture is of the film alone, without overlays.
  bool picture_is_bare = false;
};

/// Requests the frame's picture, which is there once the frame is drawn, or throws if it never is.
std::future<RgbImage> picture_of(ShownFrame& frame);

/// The processor that resamples the film.
enum class FilmDrawer {
  graphics_card,  ///< resamples a copy of the film's pyramid in a texture
  processor       ///< resamples the film itself; OpenGL receives finished pictures
};

/// A display that takes frames one by one, and draws them in its own thread.
class Presenter {
 public:
  virtual ~Presenter() = default;

  /// Waits until the frame is drawn and no longer needs its references; it is shown at the next
  /// refresh after the frame before. Rethrows faults of the drawing thread.
  virtual void draw(ShownFrame frame) = 0;

  /// Waits until the last drawn frame is shown, and returns that time: of the buffer swap, or of
  /// the handover to a headset. Rethrows as draw.
  virtual Nanoseconds wait_until_shown() = 0;

  /// The graphics card's and its driver's own names.
  virtual const std::string& graphics() const = 0;
  virtual FilmDrawer film_drawer() const = 0;
  /// Maximum turn of the head until the display of a frame, if the frame is then shown with the new
  /// orientation; 0 if it is shown with the orientation at its beginning.
  virtual double late_turn_rad() const { return 0.0; }
  /// The geometry of a window of this size (with room) while frames of `shown` are drawn: for the
  /// mouse.
  virtual ViewGeometry in_window(const ViewGeometry& shown, const IVec2& /*window_px*/) const {
    return shown;
  }
};

class FrameHandover {
 public:
  // --- The rendering thread. Each rethrows faults of the other one. ---

  /// Waits until frames are accepted.
  void wait_until_ready();
  /// Hands a frame over, once the one before is shown, and waits until it is drawn.
  void draw(ShownFrame frame);
  /// Waits until that frame is shown, and returns the time.
  Nanoseconds wait_until_shown();

  // --- The drawing thread ---

  /// Accepts frames from now on.
  void be_ready();
  /// Waits for a frame; nullopt if `stop` is requested.
  std::optional<ShownFrame> wait_for_frame(const std::stop_token& stop);
  /// The frame that was handed over, if any.
  std::optional<ShownFrame> take_frame();
  /// Notes that the frame no longer needs its references.
  void note_drawn();
  /// Notes that the frame was shown at `time`, so that another may follow.
  void note_shown(Nanoseconds time);
  /// Passes the fault on; no frames are accepted any longer.
  void fail(std::exception_ptr fault);

 private:
  /// Waits for `flag`; rethrows a fault instead.
  void wait_for(const bool& flag, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  // Guarded by the mutex:
  bool is_ready_ = false;            ///< ready for a frame: the one before is shown
  bool is_drawn_ = false;            ///< the last frame handed over
  std::optional<ShownFrame> frame_;  ///< handed over, not yet taken
  Nanoseconds shown_{0};             ///< when the last one was shown
  std::exception_ptr fault_;
};

class WindowPresenter final : public Presenter {
 public:
  /// Takes the window's context. window and clock must outlive it. framebuffer: the window's size
  /// in pixels. Throws Error if the graphics card does not support such a window.
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
  std::jthread thread_;  ///< last: it ends before the other members
};

}  // namespace foveola
