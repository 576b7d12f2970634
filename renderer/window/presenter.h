// The thread that draws: it takes frames one by one, and shows each at the display's next refresh.
#pragma once

#include <condition_variable>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/image/image.h"
#include "renderer/window/text_overlay.h"
#include "renderer/window/view_overlays.h"
#include "renderer/window/view_renderer.h"
#include "renderer/window/window.h"

namespace foveola {

/// All that the drawing thread needs for a frame.
struct ShownFrame {
  IVec2 framebuffer{0};  ///< pixels; nothing is drawn if it has none
  /// The film that the graphics card draws, or null: of the same film as before if of its size.
  const PyramidAtlas* atlas = nullptr;
  FilmUpdate update;             ///< since the frame before
  std::vector<ShownView> views;  ///< one, or one for each eye
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

class Presenter {
 public:
  /// Takes the window's context. All must outlive it. Throws Error if the graphics card cannot do
  /// it.
  Presenter(Window& window, const Clock& clock);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// Waits until the frame is drawn, and no longer needs what it refers to; it is shown at the
  /// next refresh, after the one before. Rethrows what went wrong in the drawing thread.
  void draw(ShownFrame frame);

  /// Waits until the frame that was drawn last is shown, and says when that was: its buffers were
  /// swapped. Rethrows as draw.
  Nanoseconds wait_until_shown();

  /// The graphics card and its driver, in their own words.
  const std::string& graphics() const { return graphics_; }

 private:
  struct Card;

  void run(const std::stop_token& stop);
  void serve(const std::stop_token& stop, Card& card);
  void fail(std::exception_ptr fault);
  /// Waits for `flag`, or for what goes wrong instead and rethrows it.
  void wait_for(const bool& flag, std::unique_lock<std::mutex>& lock);

  Window* window_;
  const Clock* clock_;
  std::string graphics_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  // Guarded by the mutex:
  bool is_ready_ = false;            ///< ready for a frame: the one before was shown
  bool is_drawn_ = false;            ///< the frame that was handed over last
  std::optional<ShownFrame> frame_;  ///< handed over, not taken yet
  Nanoseconds shown_{0};             ///< when the last one was
  std::exception_ptr fault_;
  std::jthread thread_;  ///< last: it ends before the rest does
};

}  // namespace foveola
