#include "study/record/read/data_quality_records.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "study/record/setup/session_devices.h"
#include "tests/study/record/study_file.h"

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
    PlayedSession session = begun_session(store);
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

// A tracker that falls silent sends no invalid sample.
TEST_F(DataQuality, AGazeOlderThanABlinkIsNone) {
  {
    StudyStore store(path_, small_protocol());
    PlayedSession session = begun_session(store);
    session.choose_and_start(ms(900));
    std::vector<FrameRow> frames = frames_from(ms(1000));
    frames[0].gaze_age = ms(600);
    frames[1].gaze_age = ms(601);
    store.record(session.id(), FrameChunk{.attempt = {}, .first = 0, .frames = frames});
    session.happen(ms(1000), FirstFramePresented{ms(1000)});
  }
  EXPECT_EQ(read_data_quality(path_).frames.at(0).untracked, 3U);
}

/// The vase is straight to the right of the camera, which looks straight ahead.
constexpr const char* with_vase_at_right =
    R"({"camera":{"position":[1,0,0],"azimuth_rad":0,"elevation_rad":0},)"
    R"("objects":[{"name":"vase","position":[3,0,0],"radius_deg":5}]})";

constexpr const char* wide_display =
    R"({"display":{"horizontal_fov_deg":90,"vertical_fov_deg":90},)"
    R"("tracker":{"profile":"camera"}})";
constexpr const char* narrow_display =
    R"({"display":{"horizontal_fov_deg":40,"vertical_fov_deg":40},)"
    R"("tracker":{"profile":"pointer"}})";

/// A person's session before `devices`, in which the vase is to be seen.
SessionFacts facts_of_person(const std::string& devices) {
  SessionFacts facts = facts_of("P01");
  facts.kind = SessionKind::human;
  facts.devices = devices;
  for (ShownScene& scene : facts.scenes) {
    scene.shown_as = with_vase_at_right;
  }
  return facts;
}

/// Frames as of frames_from, whose head is turned to 30 degrees before the vase, at which all but
/// the first two gazes look.
std::vector<FrameRow> before_the_vase(std::vector<FrameRow> frames) {
  for (FrameRow& frame : frames) {
    frame.head_azimuth_rad = static_cast<float>(radians(60.0));
    frame.gaze = {1.0F, 0.0F, 0.0F};
  }
  frames[0].gaze = frames[1].gaze = {0.0F, 0.0F, -1.0F};
  return frames;
}

/// One timing with frames, from the choice of the object to the second mark, both upon valid gaze.
void time_before_the_vase(StudyStore& store, PlayedSession& session, const AttemptKey& attempt,
                          Nanoseconds first, const std::vector<FrameRow>& frames) {
  session.choose_and_start(first - ms(1));
  store.record(session.id(), FrameChunk{.attempt = attempt, .first = 0, .frames = frames});
  session.happen(first, FirstFramePresented{first});
  session.happen(first + ms(34), Marked{first + ms(34)});
  session.happen(first + ms(50), Marked{first + ms(50)});
}

TEST_F(DataQuality, GazeAndObjectAreThoseOfEachAttemptBeforeItsOwnDisplay) {
  {
    StudyStore store(path_, small_protocol());
    PlayedSession session(store, facts_of_person(wide_display), small_plan());
    session.begin();
    time_before_the_vase(store, session, {}, ms(1000), before_the_vase(frames_from(ms(1000))));
    session.happen(ms(1100), RetimeRequested{});
    session.happen(ms(1200), NoteWritten{note_of_devices(narrow_display)});
    time_before_the_vase(store, session, {.trial = 0, .attempt = 2}, ms(2000),
                         before_the_vase(frames_from(ms(2000))));
    session.happen(ms(2100), NoteWritten{note_of_devices(wide_display)});
  }
  const std::vector<AttemptGazeRow> gaze = read_data_quality(path_).gaze;
  ASSERT_EQ(gaze.size(), 2U);
  for (const AttemptGazeRow& row : gaze) {
    EXPECT_EQ(row.participant, "P01");
    EXPECT_EQ(row.trial, 0U);
    EXPECT_NEAR(row.figures.times->all_s, 0.05, 1e-12);
    EXPECT_NEAR(row.figures.times->on_object_s.value(), 0.03, 1e-12);
    ASSERT_EQ(row.figures.marks.size(), 2U);
    EXPECT_EQ(row.figures.marks[0].mark, "outline");
    EXPECT_NEAR(row.figures.marks[0].object_from_middle_deg.value(), 30.0, 1e-3);
    EXPECT_NEAR(row.figures.marks[0].gaze_from_object_deg.value(), 0.0, 1e-3);
    EXPECT_FALSE(row.figures.fixations);
  }
  EXPECT_EQ(gaze[0].attempt, 1);
  EXPECT_EQ(gaze[0].tracker, "camera");
  EXPECT_EQ(gaze[0].figures.marks[0].object_in_view, true);
  EXPECT_EQ(gaze[1].attempt, 2);
  EXPECT_EQ(gaze[1].tracker, "pointer");
  EXPECT_EQ(gaze[1].figures.marks[0].object_in_view, false);
}

// small_protocol says nothing of its display: 100 degrees, as protocols have it.
TEST_F(DataQuality, SimulatedParticipantsSeeThroughTheProtocolsDisplay) {
  for (const auto& [azimuth_deg, is_in_view] : {std::pair(41.0, true), std::pair(39.0, false)}) {
    const fs::path path = folder_ / (is_in_view ? "seen.sqlite" : "unseen.sqlite");
    {
      StudyStore store(path, small_protocol());
      SessionFacts facts = facts_of_person("{}");
      facts.kind = SessionKind::simulated;
      PlayedSession session(store, facts, small_plan());
      session.begin();
      std::vector<FrameRow> frames = before_the_vase(frames_from(ms(1000)));
      for (FrameRow& frame : frames) {
        frame.head_azimuth_rad = static_cast<float>(radians(azimuth_deg));
      }
      time_before_the_vase(store, session, {}, ms(1000), frames);
    }
    const std::vector<AttemptGazeRow> gaze = read_data_quality(path).gaze;
    ASSERT_EQ(gaze.size(), 1U);
    EXPECT_EQ(gaze[0].tracker, "simulated");
    EXPECT_EQ(gaze[0].figures.marks.at(0).object_in_view, is_in_view);
  }
}

TEST_F(DataQuality, WhatARecordDoesNotSayOfObjectAndDisplayIsEmpty) {
  {
    StudyStore store(path_, small_protocol());
    SessionFacts facts = facts_of_person("{}");
    for (ShownScene& scene : facts.scenes) {
      scene.shown_as = "{}";
    }
    PlayedSession session(store, facts, small_plan());
    session.begin();
    time_before_the_vase(store, session, {}, ms(1000), before_the_vase(frames_from(ms(1000))));
  }
  const std::vector<AttemptGazeRow> gaze = read_data_quality(path_).gaze;
  ASSERT_EQ(gaze.size(), 1U);
  EXPECT_EQ(gaze[0].tracker, "");
  EXPECT_EQ(gaze[0].figures.times->without_gaze_s, 0.0);
  EXPECT_FALSE(gaze[0].figures.times->on_object_s);
  EXPECT_FALSE(gaze[0].figures.marks.at(0).object_in_view);
}

TEST_F(DataQuality, FixationsAreThoseOfTheRecordedSamples) {
  {
    StudyStore store(path_, small_protocol());
    PlayedSession session(store, facts_of_person(wide_display), small_plan());
    session.begin();
    std::vector<GazeSample> samples;
    for (int i = 0; i < 10; ++i) {
      samples.push_back({.time = ms(1000 + 5 * i),
                         .direction = {0.5F, 0.0F, -0.8660254F},
                         .valid = true,
                         .mark = i == 4 ? GazeMark::saccade : GazeMark::fixation});
    }
    time_before_the_vase(store, session, {}, ms(1000), before_the_vase(frames_from(ms(1000))));
    store.record(session.id(), GazeChunk{.attempt = {}, .first = 0, .samples = samples});
  }
  const FixationFigures fixations = read_data_quality(path_).gaze.at(0).figures.fixations.value();
  EXPECT_EQ(fixations.count, 2U);
  EXPECT_EQ(fixations.on_object, 2U);
  EXPECT_NEAR(fixations.mean_duration_s.value(), 0.02, 1e-12);
}

TEST_F(DataQuality, ValidationsAndReactionsAreThoseOfTheSession) {
  write_thorough_session(path_, "P01");
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

TEST_F(DataQuality, InterruptionsAndNotesAreThoseOfTheSession) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01");
    PlayedSession second = begun_session(store, "P02");
    second.happen(ms(10), NoteWritten{note_of_devices("{}")});
  }
  const std::vector<SessionCourse> courses = read_data_quality(path_).courses;
  ASSERT_EQ(courses.size(), 2U);
  EXPECT_EQ(courses[0].participant, "P01");
  EXPECT_EQ(courses[0].interruptions, 1U);
  EXPECT_EQ(courses[0].attempts_lost, 1U);
  EXPECT_THAT(courses[0].notes, ElementsAre("glasses"));
  EXPECT_EQ(courses[1].participant, "P02");
  EXPECT_EQ(courses[1].interruptions, 0U);
  EXPECT_EQ(courses[1].attempts_lost, 0U);
  EXPECT_THAT(courses[1].notes, IsEmpty());
}

TEST_F(DataQuality, WithdrawnSessionsSayNothing) {
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P01", Withdrawn{});
  }
  const DataQualityRecords records = read_data_quality(path_);
  EXPECT_THAT(records.frames, IsEmpty());
  EXPECT_THAT(records.gaze, IsEmpty());
  EXPECT_THAT(records.gaze_runs, IsEmpty());
  EXPECT_THAT(records.reactions, IsEmpty());
  EXPECT_THAT(records.courses, IsEmpty());
}

TEST_F(DataQuality, FramesAndGazeThatWereChangedAreRefused) {
  write_thorough_session(path_, "P01");
  const std::string whole = folder_.content().at("study.sqlite");
  for (const auto& [table, words] : {std::pair("frame_chunk", "frames are not those"),
                                     std::pair("gaze_chunk", "gaze samples are not those")}) {
    folder_.write("study.sqlite", whole);
    tamper(path_, std::string("UPDATE ") + table + " SET data = zeroblob(24)");
    EXPECT_THAT(refusal([&] { (void)read_data_quality(path_); }), HasSubstr(words));
  }
}

}  // namespace
}  // namespace foveola::study
