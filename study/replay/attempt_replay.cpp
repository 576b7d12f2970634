#include "study/replay/attempt_replay.h"

#include <utility>

#include "renderer/film/film_file.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/image_file.h"

namespace foveola::study {
namespace {

/// The oldest records lack the time of a frame's presentation, and repeat that of its beginning.
std::optional<Nanoseconds> first_presented(const std::vector<FrameRow>& frames) {
  const bool is_kept = !frames.empty() && frames.front().presented > frames.front().time;
  return is_kept ? std::optional(frames.front().presented) : std::nullopt;
}

}  // namespace

AttemptReplay::AttemptReplay(AttemptReplaySetting setting)
    : setting_(std::move(setting)),
      preview_(setting_.stage.tracer(), setting_.preview, eye_, head_, setting_.workers),
      first_presented_(first_presented(setting_.recorded.frames)) {
  preview_.restart(std::move(setting_.sampler), setting_.seed);
}

Nanoseconds AttemptReplay::show(Nanoseconds until) {
  return std::exchange(first_presented_, std::nullopt).value_or(until);
}

void AttemptReplay::complete_record() {
  const RecordedFrames& recorded = setting_.recorded;
  ReplayedAttempt& attempt = setting_.attempt;
  attempt.frames = recorded.frames.size();
  auto hash = recorded.hashes.begin();
  for (std::uint64_t frame = 0; frame < recorded.frames.size(); ++frame) {
    render(recorded.frames[frame]);
    if (hash != recorded.hashes.end() && hash->frame == frame) {
      ++attempt.hashes;
      if (!attempt.first_difference && film_sha256(preview_.film()) != hash->sha256) {
        attempt.first_difference = frame;
      }
      ++hash;
    }
  }
  attempt.samples = preview_.film().total_samples();
  write_picture();
  setting_.report(attempt);
}

void AttemptReplay::render(const FrameRow& frame) {
  FrameReport report = preview_.begin_frame({.time = frame.time,
                                             .heading = {.azimuth_rad = frame.head_azimuth_rad,
                                                         .elevation_rad = frame.head_elevation_rad},
                                             .roll_rad = frame.head_roll_rad},
                                            frame.gaze);
  preview_.trace(frame.samples, report);
}

void AttemptReplay::write_picture() const {
  if (setting_.picture.empty()) {
    return;
  }
  const PreviewSettings& shown = preview_.settings();
  write_image(setting_.picture,
              viewport_image(preview_.film(), preview_.viewport(), shown.view_size.x,
                             shown.view_size.y, shown.unsampled, setting_.workers),
              shown.exposure_stops);
}

}  // namespace foveola::study
