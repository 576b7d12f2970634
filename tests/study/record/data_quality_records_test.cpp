#include "study/record/data_quality_records.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "study_file.h"

namespace foveola::study {
namespace {

class DataQuality : public StudyFile {
 protected:
  /// Ten frames a hundredth of a second apart from `first` on, each shown 5 ms after its polling
  /// with a gaze 3 ms old; the fourth is late, the last two have no valid gaze.
  static std::vector<FrameRow> frames_from(Nanoseconds first) {
    std::vector<FrameRow> frames;
    for (int i = 0; i < 10; ++i) {
      frames.push_back({.time = first + ms(10 * i - 5),
                        .presented = first + ms(10 * i),
                        .gaze = {0.0F, 0.0F, -1.0F},
                        .gaze_valid = i < 8,
                        .is_late = i == 3,
                        .gaze_age = ms(3),
                        .samples = 100});
    }
    return frames;
  }
};

TEST_F(DataQuality, FramesAreOfTheCountedAttempts) {
  {
    StudyStore store(path_, small_protocol());
    PlayedSession session(store, facts_of("P01"), small_plan());
    session.begin();
    session.choose_and_start(ms(20));
    store.record(session.id(),
                 FrameChunk{.attempt = {}, .first = 0, .frames = plausible_frames(100)});
    session.happen(ms(30), FirstFramePresented{ms(30)});
    session.happen(ms(40), Marked{ms(40)});
    session.happen(ms(50), RetimeRequested{});
    session.choose_and_start(ms(55));
    store.record(session.id(), FrameChunk{.attempt = {.trial = 0, .attempt = 2},
                                          .first = 0,
                                          .frames = frames_from(ms(1000))});
    session.happen(ms(1000), FirstFramePresented{ms(1000)});
    session.happen(ms(1034), Marked{ms(1034)});
    session.happen(ms(1092), Marked{ms(1092)});
  }
  const DataQualityRecords records = read_data_quality(path_);
  ASSERT_EQ(records.frames.size(), 1U);
  const FrameFigures& figures = records.frames[0];
  EXPECT_EQ(figures.participant, "P01");
  EXPECT_EQ(figures.frames, 10U);
  EXPECT_EQ(figures.late, 1U);
  EXPECT_EQ(figures.untracked, 2U);
  EXPECT_NEAR(figures.mean_gaze_age_s, 0.003, 1e-12);
  EXPECT_NEAR(figures.mean_to_display_s, 0.005, 1e-12);
  EXPECT_NEAR(figures.longest_frame_s, 0.010, 1e-12);
  EXPECT_EQ(figures.marks, 2U);
  EXPECT_NEAR(figures.mean_mark_after_frame_s, 0.003, 1e-12);
  EXPECT_NEAR(figures.longest_mark_after_frame_s, 0.004, 1e-12);
}

TEST_F(DataQuality, ValidationsAndReactionsAreThoseOfTheSession) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
  }
  const DataQualityRecords records = read_data_quality(path_);
  EXPECT_EQ(std::to_string(records.gaze_runs.size()),
            query(path_, "SELECT count(*) FROM gaze_run"));
  EXPECT_EQ(std::to_string(records.reactions.size()),
            query(path_, "SELECT count(*) FROM reaction"));
  EXPECT_EQ(query(path_, "SELECT count(*) FROM reaction WHERE early = 1"),
            std::to_string(std::count_if(records.reactions.begin(), records.reactions.end(),
                                         [](const ReactionRow& row) { return row.early; })));
  EXPECT_FALSE(records.gaze_runs.front().passed);
  EXPECT_TRUE(records.gaze_runs.back().passed);
}

TEST_F(DataQuality, WithdrawnSessionsSayNothing) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01", Withdrawn{});
  }
  const DataQualityRecords records = read_data_quality(path_);
  EXPECT_THAT(records.frames, IsEmpty());
  EXPECT_THAT(records.gaze_runs, IsEmpty());
  EXPECT_THAT(records.reactions, IsEmpty());
}

TEST_F(DataQuality, FramesThatWereChangedAreRefused) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
  }
  tamper(path_, "UPDATE frame_chunk SET data = zeroblob(24)");
  EXPECT_THAT(refusal([&] { (void)read_data_quality(path_); }), HasSubstr("frames are not those"));
  EXPECT_THAT(refusal([&] { (void)read_data_quality(folder_ / "none"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace foveola::study
