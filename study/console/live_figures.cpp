#include "study/console/live_figures.h"

#include <algorithm>

namespace foveola::study {

void LiveFigures::begin_attempt() {
  attempt_frames_ = 0;
  attempt_late_ = 0;
}

void LiveFigures::add_attempt_frame(bool is_late) {
  ++attempt_frames_;
  attempt_late_ += is_late ? 1 : 0;
}

void LiveFigures::add_frame(Nanoseconds shown, std::span<const GazeSample> arrived) {
  constexpr Nanoseconds second = std::chrono::seconds(1);
  if (!current_) {
    current_ = Counted{.begin = shown, .end = shown};
  } else {
    ++current_->frames;
    current_->end = shown;
  }
  for (const GazeSample& sample : arrived) {
    ++current_->samples;
    if (sample.valid) {
      ++current_->valid;
      newest_valid_ = std::max(newest_valid_.value_or(sample.time), sample.time);
    }
  }
  if (current_->end - current_->begin >= second) {
    last_second_ = current_;
    current_ = Counted{.begin = shown, .end = shown};
  }
}

FrameStatus LiveFigures::frames(double refresh_rate_hz) const {
  FrameStatus status{
      .refresh_rate_hz = refresh_rate_hz, .frames = attempt_frames_, .late = attempt_late_};
  if (last_second_) {
    status.rate_hz = static_cast<double>(last_second_->frames) /
                     seconds(last_second_->end - last_second_->begin);
  }
  return status;
}

GazeStatus LiveFigures::gaze(const char* eye, Nanoseconds now) const {
  GazeStatus status{.eye = eye};
  if (last_second_ && last_second_->samples > 0) {
    status.valid =
        static_cast<double>(last_second_->valid) / static_cast<double>(last_second_->samples);
  }
  if (newest_valid_) {
    status.age_s = std::max(0.0, seconds(now - *newest_valid_));
  }
  return status;
}

}  // namespace foveola::study
