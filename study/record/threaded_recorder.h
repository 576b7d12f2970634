// The record of a session beside its frame loop: a commit takes milliseconds that a frame does not
// have.
#pragma once

#include <cstdint>
#include <memory>

#include "study/record/session_recorder.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Hands what is to be kept to a thread of its own, which commits it in this order. The store must
/// outlive it, and belongs to it meanwhile.
class ThreadedRecorder final : public SessionRecorder {
 public:
  /// session: its row in `store`.
  ThreadedRecorder(StudyStore& store, std::int64_t session);
  /// Commits what is left.
  ~ThreadedRecorder() override;
  ThreadedRecorder(const ThreadedRecorder&) = delete;
  ThreadedRecorder& operator=(const ThreadedRecorder&) = delete;

  /// The future is ready once the entry is on the disk, or throws what kept it from there; after
  /// such a fault nothing is written any more, and all later futures throw the same.
  std::future<void> record(SessionEntry entry) override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola::study
