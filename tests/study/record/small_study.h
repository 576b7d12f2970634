// A study small enough to know by heart, for the tests of its record.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "study/record/write/study_store.h"
#include "tests/temporary_folder.h"

namespace foveola::study {

using test::TemporaryFolder;

constexpr Nanoseconds ms(std::int64_t milliseconds) {
  return std::chrono::milliseconds(milliseconds);
}

/// Scenes "box" and "hall", methods "od", "fv" and a mask that no trial takes; a background
/// questionnaire, then trials with the marks "outline" and "material" and the rating "artifacts",
/// one object a scene.
Protocol small_protocol();
/// The same with another text.
Protocol other_protocol();
/// The same to the letter, with another file behind the mask.
Protocol protocol_with_another_file();
/// The same to the letter, with another profile behind the tracker's name.
Protocol protocol_with_another_tracker();
/// The same to the letter, but sessions have every part that one can have: consent, two
/// validations, two key presses, the background, the trials, and a debrief.
Protocol thorough_protocol();

/// Two targets, one of which was not seen.
GazeRun bad_run();
/// One target, which was seen through a correction.
GazeRun good_run();

/// hall fv, hall od, box od, box fv.
Plan small_plan();
/// The same, after practice with box od and with a catch trial behind the first.
Plan thorough_plan();

SessionFacts facts_of(const std::string& participant);

/// Takes a session through events and records each.
class PlayedSession {
 public:
  PlayedSession(StudyStore& store, const SessionFacts& facts, const Plan& plan,
                const Protocol& protocol = small_protocol());

  /// Fails the test if the session does not allow the event.
  void happen(Nanoseconds time, const Event& event);
  void note(const std::string& text, Nanoseconds time = ms(100));
  void begin();  ///< until the first trial's object is to be chosen
  /// Of a thorough session: the same, after a validation of gaze that passed at the second attempt.
  void begin_thoroughly();
  /// Until the first frame of the next attempt is to be presented.
  void choose_and_start(Nanoseconds time, const std::string& object = "vase");
  /// One whole trial: the first frame at `first_frame`, the marks so long after it; `measured`
  /// comes before the rating, which ends it.
  void run_trial(Nanoseconds first_frame, Nanoseconds outline, Nanoseconds material, int rating,
                 const std::vector<SessionEntry>& measured = {});

  std::int64_t id() const { return id_; }
  const SessionState& state() const { return state_; }

 private:
  StudyStore& store_;
  Procedure procedure_;
  std::int64_t id_;
  SessionState state_;
};

/// The answer to the rating "artifacts".
Rated rated(int artifacts);

/// A session of thorough_plan with everything that can happen: false starts, a time-out, a retime,
/// a pause, an interruption, a note, answers in words, and an end by `last`; frames, gaze and
/// films.
void run_thorough_session(StudyStore& store, const std::string& participant,
                          const Event& last = Excluded{.reason = "the tracker was lost"});

/// The same into a study's file, which is closed again.
void write_thorough_session(const std::filesystem::path& path, const std::string& participant,
                            const Event& last = Excluded{.reason = "the tracker was lost"});

/// A session of small_plan before its first trial.
PlayedSession begun_session(StudyStore& store, const std::string& participant = "P01");

/// A complete session of small_plan: each trial has 100 frames in two chunks, 100 gaze samples and
/// a film. Of two participants, all times and answers are the same.
void run_whole_session(StudyStore& store, const std::string& participant);

/// `count` frames as a person's might be, each other than those before it.
std::vector<FrameRow> plausible_frames(int count);
std::vector<GazeSample> plausible_gaze(int count);

/// The single value of a query, as text, by a connection of its own.
std::string query(const std::filesystem::path& path, const std::string& sql);
/// The first column of a query, by a connection of its own.
std::vector<std::string> query_column(const std::filesystem::path& path, const std::string& sql);

/// Changes a study behind the program's back: without triggers, which are there again afterwards.
void tamper(const std::filesystem::path& path, const std::string& sql);

/// The message of the Error that `work` throws; a failure and empty if it throws none.
std::string refusal(const std::function<void()>& work);

}  // namespace foveola::study
