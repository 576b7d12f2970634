#include <gtest/gtest.h>

#include "study/record/write/recorders.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

class Recording : public StudyFile {
 protected:
  /// A session in an attempt at its first trial.
  Recording() {
    PlayedSession session = begun_session(store_);
    session.choose_and_start(ms(20));
    id_ = session.id();
    state_ = session.state();
  }

  std::future<void> happen(ThreadedRecorder& recorder, Nanoseconds time, const Event& event) {
    const Transition next = step(procedure_, state_, event).value();
    std::future<void> done = recorder.record(
        EventEntry{.time = time, .event = event, .before = state_, .after = next.state});
    state_ = next.state;
    return done;
  }

  StudyStore store_{path_, small_protocol()};
  Procedure procedure_ = procedure_of(small_protocol(), small_plan());
  std::int64_t id_ = 0;
  SessionState state_;
};

TEST_F(Recording, WhatTheFutureSaysIsOnTheDisk) {
  ThreadedRecorder recorder(store_, id_);
  happen(recorder, ms(30), FirstFramePresented{ms(30)}).get();
  EXPECT_EQ(query(path_, "SELECT state FROM session"), "marking");
  happen(recorder, ms(40), Marked{ms(40)}).get();
  EXPECT_EQ(query(path_, "SELECT time_ns FROM mark"), "10000000");
}

TEST_F(Recording, KeepsTheOrderAndWritesAllBeforeItEnds) {
  {
    ThreadedRecorder recorder(store_, id_);
    happen(recorder, ms(30), FirstFramePresented{ms(30)});
    for (int chunk = 0; chunk < 20; ++chunk) {
      const auto first = static_cast<std::uint64_t>(chunk) * 10;
      recorder.record(FrameChunk{.attempt = {}, .first = first, .frames = plausible_frames(10)});
      recorder.record(GazeChunk{.attempt = {}, .first = first, .samples = plausible_gaze(10)});
      happen(recorder, ms(31 + chunk), NoteWritten{.text = std::to_string(chunk)});
    }
    recorder.record(
        FilmEntry{.attempt = {}, .hash = {.frame = 199, .sha256 = std::string(64, 'f')}});
  }
  EXPECT_EQ(
      query(path_, "SELECT group_concat(text) FROM (SELECT text FROM note ORDER BY sequence)"),
      "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19");
  EXPECT_EQ(query(path_, "SELECT sum(frame_count) FROM frame_chunk"), "200");
  EXPECT_EQ(query(path_, "SELECT sum(sample_count) FROM gaze_chunk"), "200");
  EXPECT_EQ(query(path_, "SELECT frame FROM film_hash"), "199");
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
}

TEST_F(Recording, AfterAFaultNothingIsWrittenAndAllSayWhy) {
  ThreadedRecorder recorder(store_, id_);
  happen(recorder, ms(30), FirstFramePresented{ms(30)}).get();
  // No trial 9 was planned.
  std::future<void> fault = recorder.record(
      FrameChunk{.attempt = {.trial = 9, .attempt = 1}, .first = 0, .frames = plausible_frames(1)});
  std::future<void> after = happen(recorder, ms(40), Marked{ms(40)});
  std::future<void> later =
      recorder.record(GazeChunk{.attempt = {}, .first = 0, .samples = plausible_gaze(1)});
  const std::string why = refusal([&] { fault.get(); });
  EXPECT_THAT(why, HasSubstr("FOREIGN KEY"));
  EXPECT_EQ(refusal([&] { after.get(); }), why);
  EXPECT_EQ(refusal([&] { later.get(); }), why);
  EXPECT_EQ(query(path_, "SELECT count(*) FROM mark"), "0");
  EXPECT_EQ(query(path_, "SELECT count(*) FROM gaze_chunk"), "0");
}

}  // namespace
}  // namespace foveola::study
