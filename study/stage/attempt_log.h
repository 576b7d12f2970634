// An attempt's frames and gaze samples on their way to the record, in chunks: writing one must not
// delay the next frame.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/gaze/gaze_marker.h"
#include "renderer/preview/preview.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Where an attempt's chunks go; firsts count from its start.
struct AttemptSink {
  std::function<void(std::uint64_t first_frame, std::vector<FrameRow> frames)> frames;
  std::function<void(std::uint64_t first_sample, std::vector<GazeSample> samples)> gaze;
};

/// What the record keeps of a frame, but for its presentation.
FrameRow frame_row(const FrameReport& report);

class AttemptLog {
 public:
  explicit AttemptLog(AttemptSink sink) : sink_(std::move(sink)) {}

  /// arrived: the gaze samples that came for this frame.
  void add(const FrameRow& frame, std::span<const GazeSample> arrived);
  /// The attempt is over: hands on what is left.
  void finish();

  /// So far.
  std::uint64_t frames() const { return frames_written_ + frames_.size(); }

 private:
  static constexpr std::size_t rows_per_chunk = 4096;

  void write_frames();
  void write_gaze();

  AttemptSink sink_;
  std::uint64_t frames_written_ = 0;
  std::vector<FrameRow> frames_;
  GazeMarker marker_;
  std::uint64_t gaze_written_ = 0;
  std::vector<GazeSample> gaze_;
};

}  // namespace foveola::study
