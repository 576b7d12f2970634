#include "renderer/window/frame_handover.h"

#include <utility>

namespace foveola {

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

}  // namespace foveola
