// Writes an attempt's frames and gaze samples to the record in chunks, without delaying the next
// frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/film/equirect_film.h"
#include "renderer/gaze/eye_movements.h"
#include "renderer/preview/preview.h"
#include "study/record/write/session_recorder.h"

namespace foveola::study {

/// Returns the recorded values of a frame, except its presentation.
FrameRow frame_row(const FrameReport& report);

class AttemptLog {
 public:
  /// recorder: of the attempt's session; must outlive this.
  AttemptLog(SessionRecorder& recorder, const AttemptKey& attempt)
      : recorder_(recorder), attempt_(attempt) {}

  /// arrived: the gaze samples of this frame. After finish(), nothing is added.
  void add(const FrameRow& frame, std::span<const GazeSample> arrived);
  /// Writes the rest, and the film's hash, if there was a frame. Only the first call counts.
  void finish(const EquirectFilm& film);

  /// Returns the number of added frames.
  std::uint64_t frames() const { return frames_written_ + frames_.size(); }

 private:
  static constexpr std::size_t rows_per_chunk = 4096;

  void write_frames();
  void write_gaze();

  SessionRecorder& recorder_;
  AttemptKey attempt_;
  std::uint64_t frames_written_ = 0;
  std::vector<FrameRow> frames_;
  GazeMarker marker_;
  bool is_finished_ = false;
  std::uint64_t gaze_written_ = 0;
  std::vector<GazeSample> gaze_;
};

}  // namespace foveola::study
