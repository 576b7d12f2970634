#include "study/record/buffered_recorder.h"

#include <utility>

namespace foveola::study {

std::future<void> BufferedRecorder::record(SessionEntry entry) {
  entries_.push_back(std::move(entry));
  return already_recorded();
}

void BufferedRecorder::write(StudyStore& store, const SessionFacts& facts, const Plan& plan) const {
  store.record_together([&] {
    const std::int64_t session = store.begin_session(facts, plan);
    for (const SessionEntry& entry : entries_) {
      store.record(session, entry);
    }
  });
}

}  // namespace foveola::study
