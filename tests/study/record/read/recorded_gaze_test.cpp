#include "study/record/read/recorded_gaze.h"

#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

std::vector<int> times_ms(const std::vector<GazeSample>& samples) {
  std::vector<int> times;
  for (const GazeSample& sample : samples) {
    times.push_back(static_cast<int>(sample.time / ms(1)));
  }
  return times;
}

class RecordedGaze : public StudyFile {
 protected:
  /// P01 timed the first trial twice, P02 once; neither the second trial.
  RecordedGaze() {
    StudyStore store(path_, small_protocol());
    PlayedSession first = begun_session(store);
    first.choose_and_start(ms(20));
    store.record(
        first.id(),
        GazeChunk{.attempt = {}, .first = 0, .samples = {{.time = ms(1)}, {.time = ms(2)}}});
    first.happen(ms(30), FirstFramePresented{ms(30)});
    first.happen(ms(40), Marked{ms(40)});
    first.happen(ms(50), RetimeRequested{});
    first.choose_and_start(ms(55));
    store.record(first.id(), GazeChunk{.attempt = {.trial = 0, .attempt = 2},
                                       .first = 0,
                                       .samples = {{.time = ms(60)}, {.time = ms(61)}}});
    store.record(first.id(), GazeChunk{.attempt = {.trial = 0, .attempt = 2},
                                       .first = 2,
                                       .samples = {{.time = ms(62), .mark = GazeMark::saccade}}});
    PlayedSession second = begun_session(store, "P02");
    second.choose_and_start(ms(20));
    store.record(second.id(),
                 GazeChunk{.attempt = {}, .first = 0, .samples = {{.time = ms(7), .valid = true}}});
  }
};

TEST_F(RecordedGaze, IsThatOfTheLastAttemptInOrder) {
  const std::vector<GazeSample> samples = read_gaze(path_, "P01", 0);
  EXPECT_THAT(times_ms(samples), ElementsAre(60, 61, 62));
  EXPECT_EQ(samples.at(2).mark, GazeMark::saccade);
}

TEST_F(RecordedGaze, IsVisitedAttemptByAttempt) {
  std::vector<AttemptGaze> visited;
  visit_gaze(path_, [&](const AttemptGaze& attempt) { visited.push_back(attempt); });
  ASSERT_EQ(visited.size(), 3U);
  EXPECT_THAT(times_ms(visited[0].samples), ElementsAre(1, 2));
  EXPECT_THAT(times_ms(visited[1].samples), ElementsAre(60, 61, 62));
  EXPECT_EQ(visited[0].participant, "P01");
  EXPECT_EQ(visited[0].trial, 0U);
  EXPECT_EQ(visited[0].trial_kind, "test");
  EXPECT_EQ(visited[0].scene, "hall");
  EXPECT_EQ(visited[0].method, "fv");
  EXPECT_EQ(visited[0].outcome, "retimed");
  EXPECT_EQ(visited[0].first_frame, ms(30));
  ASSERT_EQ(visited[0].marks.size(), 1U);
  EXPECT_EQ(visited[0].marks[0].mark, "outline");
  EXPECT_EQ(visited[0].marks[0].time, ms(40));
  EXPECT_EQ(visited[1].attempt, 2);
  EXPECT_FALSE(visited[1].first_frame);
  EXPECT_EQ(visited[2].participant, "P02");
}

TEST_F(RecordedGaze, WhatAVisitThrowsArrives) {
  EXPECT_THROW(visit_gaze(path_, [](const AttemptGaze&) { throw std::length_error("full"); }),
               std::length_error);
}

TEST_F(RecordedGaze, IsTheParticipantsOwn) {
  const std::vector<GazeSample> samples = read_gaze(path_, "P02", 0);
  EXPECT_THAT(times_ms(samples), ElementsAre(7));
  EXPECT_TRUE(samples.at(0).valid);
}

TEST_F(RecordedGaze, ThatIsNotThereIsRefused) {
  EXPECT_THAT(refusal([&] { read_gaze(path_, "P01", 1); }),
              AllOf(HasSubstr(path_.string()), HasSubstr("no gaze of participant P01 in trial 1")));
  EXPECT_THAT(refusal([&] { read_gaze(path_, "P09", 0); }), HasSubstr("participant P09"));
  EXPECT_THAT(refusal([&] { read_gaze(folder_ / "none", "P01", 0); }), HasSubstr("no such file"));
}

TEST_F(RecordedGaze, ThatWasChangedIsRefused) {
  tamper(path_, "UPDATE gaze_chunk SET data = zeroblob(24) WHERE sample_count = 1");
  EXPECT_THAT(refusal([&] { read_gaze(path_, "P02", 0); }),
              HasSubstr("its gaze samples are not those that were written"));
}

}  // namespace
}  // namespace foveola::study
