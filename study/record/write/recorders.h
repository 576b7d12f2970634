// The records of a session that reach the disk entry by entry, with the whole session, or beside
// its frame loop.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "study/record/write/session_recorder.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// Writes entry by entry, each before its call returns.
class StoreRecorder final : public SessionRecorder {
 public:
  /// session: its row in `store`, which must outlive this.
  StoreRecorder(StudyStore& store, std::int64_t session) : store_(store), session_(session) {}

  std::future<void> record(SessionEntry entry) override {
    store_.record(session_, entry);
    return already_recorded();
  }

 private:
  StudyStore& store_;
  std::int64_t session_;
};

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

/// Hands what is to be kept to a thread of its own, which commits it in this order: a commit takes
/// milliseconds that a frame does not have. The store must outlive it, and belongs to it meanwhile.
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
