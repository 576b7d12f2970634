// Compares each event that a replayed session makes with the recorded one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/record/write/session_recorder.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

class ComparedRecord final : public SessionRecorder {
 public:
  /// events: the recorded ones; must outlive this.
  explicit ComparedRecord(const std::vector<LoggedEvent>& events) : events_(events) {}

  /// Events after the last recorded one are not compared: the recording program ended there.
  std::future<void> record(SessionEntry entry) override;

  bool is_at_end() const { return next_ == events_.size(); }
  /// Returns the next expected event; not at the end.
  const LoggedEvent& next() const { return events_[next_]; }
  /// Number of events that were made, or replaced recorded ones.
  std::size_t made() const { return next_; }
  /// Returns the notes that come next, after the session's start if that is next.
  std::vector<std::string> next_notes() const;
  /// Returns the time of the next event, at the end that of the last; session clock.
  Nanoseconds time() const;

  /// Reports that the session cannot make the next event: the first difference, unless there is
  /// one.
  void differ(const std::string& how);
  /// Returns the first difference, with the event's number; empty if there is none.
  const std::string& difference() const { return difference_; }

 private:
  const std::vector<LoggedEvent>& events_;
  std::size_t next_ = 0;
  std::string difference_;
};

}  // namespace foveola::study
