// The record of a session that reaches the disk entry by entry, before each call returns.
#pragma once

#include <cstdint>
#include <utility>

#include "study/record/session_recorder.h"
#include "study/record/study_store.h"

namespace foveola::study {

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

}  // namespace foveola::study
