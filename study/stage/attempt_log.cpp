#include "study/stage/attempt_log.h"

#include <utility>

#include "renderer/film/film_file.h"

namespace foveola::study {

FrameRow frame_row(const FrameReport& report) {
  return {.time = report.time,
          .head_azimuth_rad = static_cast<float>(report.head.azimuth_rad),
          .head_elevation_rad = static_cast<float>(report.head.elevation_rad),
          .head_roll_rad = static_cast<float>(report.head_roll_rad),
          .gaze = report.gaze,
          .gaze_valid = report.gaze_valid,
          .gaze_held = report.gaze_held,
          .gaze_age = report.gaze_age,
          .samples = static_cast<std::uint32_t>(report.samples)};
}

void AttemptLog::add(const FrameRow& frame, std::span<const GazeSample> arrived) {
  if (is_finished_) {
    return;
  }
  frames_.push_back(frame);
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

void AttemptLog::finish(const EquirectFilm& film) {
  if (std::exchange(is_finished_, true)) {
    return;
  }
  marker_.finish(gaze_);
  write_frames();
  write_gaze();
  if (frames() > 0) {
    recorder_.record(FilmEntry{.attempt = attempt_,
                               .hash = {.frame = frames() - 1, .sha256 = film_sha256(film)}});
  }
}

void AttemptLog::write_frames() {
  if (!frames_.empty()) {
    const std::size_t count = frames_.size();
    recorder_.record(FrameChunk{
        .attempt = attempt_, .first = frames_written_, .frames = std::exchange(frames_, {})});
    frames_written_ += count;
  }
}

void AttemptLog::write_gaze() {
  if (!gaze_.empty()) {
    const std::size_t count = gaze_.size();
    recorder_.record(GazeChunk{
        .attempt = attempt_, .first = gaze_written_, .samples = std::exchange(gaze_, {})});
    gaze_written_ += count;
  }
}

}  // namespace foveola::study
