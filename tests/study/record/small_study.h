// A study small enough to know by heart, for the tests of its record.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "study/record/study_store.h"
#include "tests/temporary_folder.h"

namespace foveola::study {

using test::TemporaryFolder;

constexpr Nanoseconds ms(std::int64_t milliseconds) {
  return std::chrono::milliseconds(milliseconds);
}

/// Scenes "box" and "hall", methods "od", "fv" and a mask that no trial takes.
Protocol small_protocol();
/// The same with another text.
Protocol other_protocol();
/// The same to the letter, with another file behind the mask.
Protocol protocol_with_another_file();
/// The same to the letter, with another profile behind the tracker's name.
Protocol protocol_with_another_tracker();

/// Two targets, one of which was not seen.
GazeRun bad_run();
/// One target, which was seen through a correction.
GazeRun good_run();

/// hall fv, hall od, box od, box fv.
Plan small_plan();

SessionFacts facts_of(const std::string& participant);

/// Takes a session through events and records each.
class RecordedSession {
 public:
  RecordedSession(StudyStore& store, const SessionFacts& facts, const Plan& plan);

  /// Fails the test if the session does not allow the event.
  void happen(Nanoseconds time, const Event& event);
  void begin();  ///< until the first trial's object is to be chosen
  /// The same, after a validation of gaze that passed at the second attempt.
  void begin_validated();
  /// One whole trial: the first frame at `first_frame`, the marks so long after it.
  void run_trial(Nanoseconds first_frame, Nanoseconds outline, Nanoseconds material, int rating);

  std::int64_t id() const { return id_; }
  const SessionState& state() const { return state_; }

 private:
  StudyStore& store_;
  Plan plan_;
  std::int64_t id_;
  SessionState state_;
};

/// The single value of a query, as text, by a connection of its own.
std::string query(const std::filesystem::path& path, const std::string& sql);

/// The message of the Error that `work` throws; a failure and empty if it throws none.
std::string refusal(const std::function<void()>& work);

}  // namespace foveola::study
