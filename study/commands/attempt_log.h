// An attempt's frames and gaze samples on their way to the disk, in chunks: writing one must not
// delay the next frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gaze/gaze_marker.h"
#include "renderer/preview/preview.h"
#include "study/record/study_store.h"

namespace foveola::study {

class AttemptLog {
 public:
  AttemptLog(StudyStore& store, std::int64_t session, std::size_t trial, int attempt)
      : store_(store), session_(session), trial_(trial), attempt_(attempt) {}

  /// arrived: the gaze samples that came for this frame.
  void add(const FrameReport& report, std::span<const GazeSample> arrived);
  /// The attempt is over: writes what is not yet on the disk.
  void finish();

 private:
  static constexpr std::size_t rows_per_chunk = 4096;

  void write_frames();
  void write_gaze();

  StudyStore& store_;
  std::int64_t session_;
  std::size_t trial_;
  int attempt_;
  std::uint64_t frames_written_ = 0;
  std::vector<FrameRow> frames_;
  GazeMarker marker_;
  std::uint64_t gaze_written_ = 0;
  std::vector<GazeSample> gaze_;
};

}  // namespace foveola::study
