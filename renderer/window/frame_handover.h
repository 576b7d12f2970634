// Frames on their way from the thread that renders them to the one that draws.
#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>

#include "renderer/window/presenter.h"

namespace foveola {

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

}  // namespace foveola
