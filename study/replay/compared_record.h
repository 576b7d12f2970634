// The record of a session that is driven again: compares each event that the driver makes with the
// one that was recorded.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/record/session_recorder.h"
#include "study/record/study_store.h"

namespace foveola::study {

class ComparedRecord final : public SessionRecorder {
 public:
  /// events: what was recorded; must outlive this.
  explicit ComparedRecord(const std::vector<LoggedEvent>& events) : events_(events) {}

  /// What is made after the last recorded event is not compared: the program that recorded them
  /// ended there.
  std::future<void> record(SessionEntry entry) override;

  bool is_at_end() const { return next_ == events_.size(); }
  /// The event that has to be made next; not at the end.
  const LoggedEvent& next() const { return events_[next_]; }
  /// How many events were made, or stood in the place of recorded ones.
  std::size_t made() const { return next_; }
  /// The notes that come next, behind the session's start if that does.
  std::vector<std::string> next_notes() const;
  /// The time of the next event, at the end that of the last; session clock.
  Nanoseconds time() const;

  /// The session cannot make the next event. Unless there was a difference before, this is it.
  void differ(const std::string& how);
  /// The first difference, with the event's number; empty if there is none.
  const std::string& difference() const { return difference_; }

 private:
  const std::vector<LoggedEvent>& events_;
  std::size_t next_ = 0;
  std::string difference_;
};

}  // namespace foveola::study
