#include "study/commands/attempt_log.h"

namespace foveola::study {

void AttemptLog::add(const FrameReport& report, std::span<const GazeSample> arrived) {
  frames_.push_back({.time = report.time,
                     .head_azimuth_rad = static_cast<float>(report.head.azimuth_rad),
                     .head_elevation_rad = static_cast<float>(report.head.elevation_rad),
                     .gaze = report.gaze,
                     .gaze_valid = report.gaze_valid,
                     .gaze_held = report.gaze_held,
                     .gaze_age = report.gaze_age,
                     .samples = static_cast<std::uint32_t>(report.samples)});
  for (const GazeSample& sample : arrived) {
    marker_.push(sample, gaze_);
  }
  if (frames_.size() >= rows_per_chunk) {
    write_frames();
  }
  if (gaze_.size() >= rows_per_chunk) {
    write_gaze();
  }
}

void AttemptLog::finish() {
  marker_.finish(gaze_);
  write_frames();
  write_gaze();
}

void AttemptLog::write_frames() {
  if (!frames_.empty()) {
    store_.record_frames(session_, trial_, attempt_, frames_written_, frames_);
    frames_written_ += frames_.size();
    frames_.clear();
  }
}

void AttemptLog::write_gaze() {
  if (!gaze_.empty()) {
    store_.record_gaze(session_, trial_, attempt_, gaze_written_, gaze_);
    gaze_written_ += gaze_.size();
    gaze_.clear();
  }
}

}  // namespace foveola::study
