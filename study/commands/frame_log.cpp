#include "study/commands/frame_log.h"

namespace foveola::study {

void FrameLog::add(const FrameReport& report) {
  rows_.push_back({.time = report.time,
                   .head_azimuth_rad = static_cast<float>(report.head.azimuth_rad),
                   .head_elevation_rad = static_cast<float>(report.head.elevation_rad),
                   .gaze = report.gaze,
                   .gaze_valid = report.gaze_valid,
                   .gaze_held = report.gaze_held,
                   .gaze_age = report.gaze_age,
                   .samples = static_cast<std::uint32_t>(report.samples)});
  if (rows_.size() == frames_per_chunk) {
    flush();
  }
}

void FrameLog::flush() {
  if (rows_.empty()) {
    return;
  }
  store_.record_frames(session_, trial_, attempt_, flushed_, rows_);
  flushed_ += rows_.size();
  rows_.clear();
}

}  // namespace foveola::study
