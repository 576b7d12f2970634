#include "renderer/preview/live_frames.h"

#include <cassert>
#include <utility>

namespace foveola {

LiveFrames::LiveFrames(Preview& preview, const Clock& clock, double refresh_rate_hz,
                       WaitUntil wait_until, Present present)
    : preview_(&preview),
      clock_(&clock),
      wait_until_(std::move(wait_until)),
      present_(std::move(present)),
      refresh_interval_(nanoseconds_from_seconds(1.0 / refresh_rate_hz)),
      next_refresh_(clock.now()) {
  assert(refresh_rate_hz > 0.0);
}

LiveFrame LiveFrames::next() {
  wait_until_(next_refresh_);
  LiveFrame frame{.start = clock_->now(), .deadline = next_refresh_ + refresh_interval_};
  frame.report = preview_->begin_frame(frame.start);
  frame.polling = clock_->now() - frame.start;
  trace(frame);
  const Nanoseconds traced = clock_->now();
  present_(*preview_);
  const Nanoseconds end = clock_->now();
  frame.presenting = end - traced;
  budget_.rest_took(frame.presenting);
  next_refresh_ = frame.deadline;
  while (next_refresh_ < end) {
    next_refresh_ += refresh_interval_;
    ++frame.missed_refreshes;
  }
  budget_.frame_ended(frame.is_late());
  return frame;
}

void LiveFrames::trace(LiveFrame& frame) {
  trace_batch(budget_.first_batch(frame.deadline - clock_->now()), frame);
  const std::uint64_t more = budget_.second_batch(frame.deadline - clock_->now());
  if (more > 0) {
    trace_batch(more, frame);
  }
}

void LiveFrames::trace_batch(std::uint64_t samples, LiveFrame& frame) {
  const Nanoseconds start = clock_->now();
  preview_->trace(samples, frame.report);
  const Nanoseconds took = clock_->now() - start;
  budget_.batch_took(samples, took);
  frame.tracing += took;
}

}  // namespace foveola
