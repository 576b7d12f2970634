// Writing beside the frame loop: a commit takes milliseconds that a frame does not have.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

/// Hands what is to be kept to a thread of its own, which commits it in this order. The store must
/// outlive it, and belongs to it meanwhile.
class RecordThread {
 public:
  explicit RecordThread(StudyStore& store);
  /// Commits what is left.
  ~RecordThread();
  RecordThread(const RecordThread&) = delete;
  RecordThread& operator=(const RecordThread&) = delete;

  /// The future is ready once it is on the disk, or throws what kept it from there; after such a
  /// fault nothing is written any more, and all later futures throw the same.
  std::future<void> event(std::int64_t session, Nanoseconds time, Event event, SessionState before,
                          SessionState after);
  std::future<void> frames(std::int64_t session, std::size_t trial, int attempt,
                           std::uint64_t first_frame, std::vector<FrameRow> frames);
  std::future<void> gaze(std::int64_t session, std::size_t trial, int attempt,
                         std::uint64_t first_sample, std::vector<GazeSample> samples);
  std::future<void> film_hash(std::int64_t session, std::size_t trial, int attempt, FilmHash hash);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola::study
