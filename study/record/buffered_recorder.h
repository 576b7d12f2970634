// The record of a session that reaches the disk whole, once the session is over.
#pragma once

#include <vector>

#include "study/record/session_recorder.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Keeps a whole session in memory: 72 bytes a frame and 48 a sample of the gaze, 30 MB for the
/// longest published session (15 trials that all time out) and some hundred kilobytes for a
/// predicted one. Only for simulated participants: to them nothing is acknowledged.
class BufferedRecorder final : public SessionRecorder {
 public:
  std::future<void> record(SessionEntry entry) override;

  /// All that was kept, as the record of a new session: on the disk whole when this returns, or not
  /// at all.
  void write(StudyStore& store, const SessionFacts& facts, const Plan& plan) const;

 private:
  std::vector<SessionEntry> entries_;
};

}  // namespace foveola::study
