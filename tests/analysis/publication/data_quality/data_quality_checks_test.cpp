#include "analysis/publication/data_quality/data_quality_checks.h"

#include <algorithm>
#include <span>

#include "analysis/statistics/distributions.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

study::FrameFigures good_frames(const std::string& participant) {
  return {.participant = participant,
          .frames = 10'000,
          .late = 20,
          .untracked = 100,
          .mean_gaze_age_s = 0.006,
          .mean_to_display_s = 0.02,
          .longest_frame_s = 0.03,
          .marks = 30,
          .mean_mark_after_frame_s = 0.007,
          .longest_mark_after_frame_s = 0.02};
}

const DataQualityCheck& check_of(const DataQualityReport& report, const std::string& name) {
  const auto found = std::find_if(
      report.checks.begin(), report.checks.end(),
      [&](const DataQualityCheck& check) { return check.name.find(name) != std::string::npos; });
  if (found == report.checks.end()) {
    throw std::out_of_range(name);
  }
  return *found;
}

/// A catch trial of the first session, with a mark or timed out.
void add_catch_trial(study::StudyRecords& records, bool has_mark) {
  study::TrialRow row = records.trials.front();
  row.kind = study::TrialKind::catch_trial;
  records.add_trial(row, {has_mark ? measured(2.5) : right_censored(8.0), {}, {}});
}

DataQualityReport report_on(const study::StudyRecords& records,
                            const study::DataQualityRecords& quality = {}) {
  return check_data_quality(tabulate_study(records), quality, records);
}

/// The check of this name on the study.
DataQualityCheck check_on(const study::StudyRecords& records, const std::string& name,
                          const study::DataQualityRecords& quality = {}) {
  return check_of(report_on(records, quality), name);
}

void expect_check(const DataQualityCheck& check, Verdict verdict, const std::string& found) {
  EXPECT_EQ(check.verdict, verdict);
  EXPECT_EQ(check.value_text, found);
}

/// Every method in another place from trial to trial.
void balance_methods(study::StudyRecords& records) {
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = static_cast<std::uint16_t>((trial % 3 + trial / 3) % 3);
    ++trial;
  }
}

TEST(DataQualityChecks, GoodDataPass) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("P2")};
  quality.gaze_runs = {{"P1", 1, 5.0, 0.1, 0.0, false},
                       {"P1", 2, 0.8, 0.1, 0.0, true},
                       {"P2", 1, 0.9, 0.1, 0.0, true}};
  const DataQualityReport report = report_on(complete_study(2), quality);
  for (const char* name :
       {"refresh", "valid gaze", "Latency", "mark upon it", "Validation", "People", "Retimed"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::passed) << name;
  }
  EXPECT_THAT(check_of(report, "Validation").value_text, HasSubstr("0.90° at most"));
}

TEST(DataQualityChecks, WhatWasMissedIsFlaggedWithWhoMissedItMost) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("P2")};
  quality.frames[1].late = 500;
  quality.frames[1].untracked = 2000;
  quality.frames[1].mean_gaze_age_s = 0.09;
  quality.frames[1].longest_mark_after_frame_s = 0.5;
  const DataQualityReport report = report_on(complete_study(2), quality);
  for (const char* name : {"refresh", "valid gaze", "Latency", "mark upon it"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::flagged) << name;
    EXPECT_THAT(check_of(report, name).value_text,
                AllOf(HasSubstr("participant P2"), EndsWith("above the limit: P2")));
  }
}

TEST(DataQualityChecks, EverybodyAboveAFramesLimitIsNamed) {
  study::DataQualityRecords quality;
  for (int i = 1; i <= 8; ++i) {
    quality.frames.push_back(good_frames("P" + std::to_string(i)));
    quality.frames.back().late = i == 3 ? 20 : 100 + 10 * static_cast<std::uint64_t>(i);
  }
  const DataQualityReport report = report_on(complete_study(8), quality);
  EXPECT_EQ(check_of(report, "refresh").value_text,
            "at most 1.8 %, participant P8; above the limit: P1, P2, P4, P5, P6, P7, P8");
  EXPECT_THAT(check_of(report, "valid gaze").value_text, EndsWith("above the limit: none"));
}

TEST(DataQualityChecks, WhoIsNotAnalysedDoesNotCount) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("X")};
  quality.frames[1].late = 9000;
  EXPECT_EQ(check_on(complete_study(1), "refresh", quality).verdict, Verdict::passed);
}

TEST(DataQualityChecks, WhatWasNotRecordedIsNotCalledGood) {
  const DataQualityReport report = report_on(complete_study(2));
  for (const char* name : {"refresh", "valid gaze", "Latency", "Validation", "out of view",
                           "gaze elsewhere", "Interrupted", "Notes", "Programs"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::unknown) << name;
  }
  EXPECT_TRUE(report.reactions.empty());
}

TEST(DataQualityChecks, OnlyTheLastValidationCounts) {
  study::DataQualityRecords quality;
  quality.gaze_runs = {{"P1", 1, 0.5, 0.1, 0.0, true}, {"P1", 2, 4.0, 0.1, 0.4, false}};
  EXPECT_EQ(check_on(complete_study(1), "Validation", quality).verdict, Verdict::flagged);
}

TEST(DataQualityChecks, AMouseInPlaceOfAnEyeAndSessionsThatDifferAreFlagged) {
  const study::StudyRecords records = complete_study(2);
  study::DataQualityRecords quality;
  quality.gaze = {{.participant = "P1", .tracker = "fove0"},
                  {.participant = "X", .tracker = "hid"}};
  EXPECT_EQ(check_on(records, "Source").verdict, Verdict::unknown);
  EXPECT_EQ(check_on(records, "Source", quality).verdict, Verdict::passed);
  quality.gaze.push_back({.participant = "P2", .tracker = "pointer"});
  expect_check(check_on(records, "Source", quality), Verdict::flagged,
               "the eye tracker of profile fove0 (P1); the mouse pointer in place of an eye (P2)");
  quality.gaze.erase(quality.gaze.begin());
  expect_check(check_on(records, "Source", quality), Verdict::flagged,
               "the mouse pointer in place of an eye");
}

TEST(DataQualityChecks, ManyTimesThatRanOutAreFlagged) {
  study::StudyRecords records = complete_study(5);
  EXPECT_EQ(check_on(records, "Right-censored").value_text, "none");
  for (const char* participant : {"P1", "P2"}) {
    value_of(records, participant, "aula", "od", "outline") = right_censored(60.0);
  }
  EXPECT_EQ(check_on(records, "Right-censored").verdict, Verdict::passed);
  value_of(records, "P3", "aula", "od", "outline") = right_censored(60.0);
  expect_check(check_on(records, "Right-censored"), Verdict::flagged, "outline with OD 30.0 %");
}

TEST(DataQualityChecks, AMethodThatAlwaysComesFirstIsFlagged) {
  study::StudyRecords records = complete_study(8);
  for (study::TrialRow& row : records.trials) {
    row.method_position = row.method;
  }
  EXPECT_EQ(check_on(records, "order").verdict, Verdict::flagged);
  balance_methods(records);
  const DataQualityCheck balanced = check_on(records, "order");
  EXPECT_EQ(balanced.verdict, Verdict::passed);
  EXPECT_THAT(balanced.value_text, HasSubstr("5 to 6 times"));
}

// Each participant's methods are permuted within the scene, so counts vary less than free ones:
// the check's level is kept only if it takes that into account.
TEST(DataQualityChecks, OneRandomDesignInAHundredIsFlagged) {
  constexpr std::size_t designs = 3000;
  const study::StudyRecords records = complete_study(40);
  StudyTables tables = tabulate_study(records);
  const std::size_t methods = tables.set.methods.size();
  Pcg32 generator(26, 1);
  std::size_t flagged = 0;
  for (std::size_t design = 0; design < designs; ++design) {
    std::vector<int> places = {0, 1, 2};
    for (std::size_t i = 0; i < tables.set.trials.size(); ++i) {
      if (i % methods == 0) {
        shuffle(std::span(places), generator);
      }
      tables.set.trials[i].method_position = places[i % methods];
    }
    flagged +=
        check_of(check_data_quality(tables, {}, records), "order").verdict == Verdict::flagged ? 1
                                                                                               : 0;
  }
  const Interval share = clopper_pearson(flagged, designs, 0.999);
  EXPECT_LE(share.low, 0.01) << flagged;
  EXPECT_GE(share.high, 0.01) << flagged;
}

TEST(DataQualityChecks, ASceneWithAMissingTrialSaysNothingOfTheOrder) {
  study::StudyRecords records = complete_study(6);
  balance_methods(records);
  EXPECT_THAT(check_on(records, "order").value_text, HasSubstr("each method 4 to 4 times"));
  records.trials.pop_back();
  records.values.resize(records.trials.size() * records.measures.size());
  EXPECT_THAT(check_on(records, "order").value_text, HasSubstr("each method 3 to 4 times"));
}

TEST(DataQualityChecks, MarksAreHeldAgainstTheReactionFloor) {
  study::StudyRecords records = complete_study(2);
  value_of(records, "P1", "aula", "fv", "outline") = measured(0.2);
  study::DataQualityRecords quality;
  quality.reactions = {
      {"P1", 0.3, false}, {"P1", 0.2, false}, {"P1", 0.4, false}, {"P1", -0.05, true}};
  const DataQualityReport report = report_on(records, quality);
  ASSERT_EQ(report.reactions.size(), 1U);
  const ReactionFloor& floor = report.reactions[0];
  EXPECT_EQ(floor.presses, 3U);
  EXPECT_EQ(floor.false_starts, 1U);
  EXPECT_DOUBLE_EQ(floor.median_s.value(), 0.3);
  EXPECT_EQ(floor.marks, 12U);
  EXPECT_EQ(floor.within_floor, 1U);
}

// 0.055 s, of which a simple reaction alone takes more.
TEST(DataQualityChecks, AMarkSoonerThanAnybodySeesIsFlaggedOfOneParticipantToo) {
  study::StudyRecords records = complete_study(1);
  EXPECT_EQ(check_on(records, "sooner than").verdict, Verdict::passed);
  value_of(records, "P1", "aula", "fv", "outline") = measured(0.055);
  const DataQualityCheck early = check_on(records, "sooner than");
  EXPECT_EQ(early.verdict, Verdict::flagged);
  EXPECT_THAT(early.value_text, HasSubstr("P1, aula, fv, outline: 0.055 s"));
}

TEST(DataQualityChecks, WhatSessionsRanOnIsComparedIfTheyAreAnalysed) {
  const study::StudyRecords records = complete_study(2);
  study::DataQualityRecords quality;
  const auto on = [](const std::string& participant, const std::string& threads) {
    return study::SessionSetup{
        participant, "human", {R"({"machine":{"threads":)" + threads + "}}"}};
  };
  quality.setups = {on("P1", "2"), on("P2", "2"), on("P3", "8")};
  EXPECT_EQ(check_on(records, "machines", quality).verdict, Verdict::passed);
  quality.setups[1] = on("P2", "4");
  expect_check(check_on(records, "machines", quality), Verdict::flagged,
               "threads: 2 in P1; 4 in P2");
}

TEST(DataQualityChecks, MarksInCatchTrialsAreFalseAlarms) {
  study::StudyRecords records = complete_study(1);
  EXPECT_EQ(check_of(report_on(records), "False alarms").verdict, Verdict::unknown);
  for (int i = 0; i < 9; ++i) {
    add_catch_trial(records, false);
  }
  const DataQualityReport none = report_on(records);
  EXPECT_EQ(check_of(none, "False alarms").verdict, Verdict::passed);
  EXPECT_EQ(none.catches.at(0).trials, 9U);
  EXPECT_EQ(none.catches.at(0).false_alarms, 0U);
  for (int i = 0; i < 3; ++i) {
    add_catch_trial(records, true);
  }
  const DataQualityReport some = report_on(records);
  EXPECT_EQ(some.catches.at(0).participant, "P1");
  EXPECT_EQ(some.catches.at(0).trials, 12U);
  EXPECT_EQ(some.catches.at(0).false_alarms, 3U);
  EXPECT_DOUBLE_EQ(some.catches.at(0).false_alarms_percent(), 25.0);
  EXPECT_EQ(check_of(some, "False alarms").verdict, Verdict::flagged);
  EXPECT_THAT(check_of(some, "False alarms").value_text,
              HasSubstr("a mark in 3 of 12 catch trials; above the limit: P1"));
}

TEST(DataQualityChecks, CatchTrialsThatWereNotBegunOrAreTimedAgainDoNotCount) {
  study::StudyRecords records = complete_study(1);
  add_catch_trial(records, true);
  records.trials.back().counts = false;
  add_catch_trial(records, false);
  records.trials.back().attempt = 0;
  EXPECT_TRUE(report_on(records).catches.empty());
}

/// Numbers the trials of each session and has one row of gaze for each, with the object in view and
/// the gaze on it.
std::vector<study::AttemptGazeRow> gaze_on_objects(study::StudyRecords& records) {
  std::vector<study::AttemptGazeRow> gaze;
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    study::TrialRow& row = records.trials[i];
    row.trial = static_cast<std::uint32_t>(i);
    gaze.push_back({.participant = records.participant_of(row),
                    .trial = i,
                    .tracker = "camera",
                    .figures = {.times = study::GazeTimes{.all_s = 10.0,
                                                          .without_gaze_s = 1.0,
                                                          .on_object_s = 4.0,
                                                          .elsewhere_s = 5.0},
                                .marks = {{.mark = "outline", .object_in_view = true},
                                          {.mark = "material", .object_in_view = true}}}});
  }
  return gaze;
}

TEST(DataQualityChecks, GazeUpToHalfTheTimeElsewhereAndObjectsInViewPass) {
  study::StudyRecords records = complete_study(1);
  study::DataQualityRecords quality;
  quality.gaze = gaze_on_objects(records);
  expect_check(check_on(records, "out of view", quality), Verdict::passed, "0 of 12 marks");
  expect_check(check_on(records, "gaze elsewhere", quality), Verdict::passed, "0 of 6 trials");
}

TEST(DataQualityChecks, OfManyMarksOutOfViewFiveAreToldAndEverybodyIsNamed) {
  study::StudyRecords records = complete_study(4);
  study::DataQualityRecords quality;
  quality.gaze = gaze_on_objects(records);
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U, 12U, 18U}) {
    quality.gaze[i].figures.marks[1].object_in_view = false;
  }
  expect_check(
      check_on(records, "out of view", quality), Verdict::flagged,
      "8 of 48 marks: P1, aula, od, material; P1, aula, vp, material; P1, aula, fv, material; "
      "P1, barn, vp, material; P1, barn, fv, material; and 3 others of P2, P3, P4");
}

TEST(DataQualityChecks, WhoseGazeIsNotKnownIsNotCalledGood) {
  study::StudyRecords records = complete_study(1);
  study::DataQualityRecords quality;
  quality.gaze = gaze_on_objects(records);
  for (study::AttemptGazeRow& row : quality.gaze) {
    row.figures.times->elsewhere_s.reset();
    row.figures.marks = {{.mark = "outline"}};
  }
  const DataQualityReport report = report_on(records, quality);
  EXPECT_EQ(check_of(report, "out of view").verdict, Verdict::unknown);
  EXPECT_EQ(check_of(report, "gaze elsewhere").verdict, Verdict::unknown);
  EXPECT_EQ(check_of(report_on(records), "gaze elsewhere").verdict, Verdict::unknown);
}

TEST(DataQualityChecks, OnlyTheLastTimingsOfAnalysedTestTrialsAreHeldAgainstTheGaze) {
  study::StudyRecords records = complete_study(3);
  records.sessions[1].state = "interrupted";
  study::DataQualityRecords quality;
  quality.gaze = gaze_on_objects(records);
  records.trials[0].kind = study::TrialKind::practice;
  records.trials[1].kind = study::TrialKind::catch_trial;
  records.trials[2].counts = false;
  for (std::size_t i = 0; i < 12; ++i) {
    if (i < 3 || i >= 6) {
      quality.gaze[i].figures.times->elsewhere_s = 9.0;
      quality.gaze[i].figures.marks[0].object_in_view = false;
    }
  }
  const DataQualityReport report = report_on(records, quality);
  EXPECT_EQ(check_of(report, "out of view").value_text, "0 of 18 marks");
  EXPECT_EQ(check_of(report, "gaze elsewhere").value_text, "0 of 9 trials");
}

TEST(DataQualityChecks, SessionsThatWentThroughWithoutAWordPass) {
  study::DataQualityRecords quality;
  quality.courses = {{.participant = "P1"}, {.participant = "P2"}};
  expect_check(check_on(complete_study(2), "Interrupted", quality), Verdict::passed, "none");
  expect_check(check_on(complete_study(2), "Notes", quality), Verdict::passed, "none");
}

TEST(DataQualityChecks, WhoseSessionWasCutOffIsNamedIfAnalysed) {
  study::StudyRecords records = complete_study(4);
  records.sessions[3].state = "interrupted";
  study::DataQualityRecords quality;
  quality.courses = {{.participant = "P1", .interruptions = 1, .attempts_lost = 0},
                     {.participant = "P2"},
                     {.participant = "P3", .interruptions = 2, .attempts_lost = 1},
                     {.participant = "P4", .interruptions = 3, .attempts_lost = 3}};
  expect_check(check_on(records, "Interrupted", quality), Verdict::flagged,
               "P1: 1 time, 0 attempts lost; P3: 2 times, 1 attempt lost");
}

TEST(DataQualityChecks, EverybodyWithNotesIsNamedWithTheFirst) {
  study::StudyRecords records = complete_study(3);
  records.sessions[2].state = "interrupted";
  study::DataQualityRecords quality;
  quality.courses = {
      {.participant = "P1",
       .notes = {"the eye tracker sends no gaze", "the eye tracker sends gaze again"}},
      {.participant = "P2", .notes = {std::string(100, 'x') + "\nand more"}},
      {.participant = "P3", .notes = {"not analysed"}}};
  expect_check(
      check_on(records, "Notes", quality), Verdict::flagged,
      "P1: the eye tracker sends no gaze (and 1 more); P2: " + std::string(80, 'x') + " …");
}

TEST(DataQualityChecks, OneProgramForAllSessionsPasses) {
  study::StudyRecords records = complete_study(2);
  records.programs = {{"P1", {"Foveola 1"}}, {"P2", {"Foveola 1"}}};
  expect_check(check_on(records, "Programs"), Verdict::passed, "Foveola 1 in 2 sessions");
}

TEST(DataQualityChecks, EveryProgramOfTheAnalysedSessionsIsNamed) {
  study::StudyRecords records = complete_study(3);
  records.sessions[2].state = "interrupted";
  records.programs = {
      {"P1", {"Foveola 1"}}, {"P2", {"Foveola 1", "Foveola 2"}}, {"P3", {"Foveola 3"}}};
  expect_check(check_on(records, "Programs"), Verdict::flagged,
               "Foveola 1 in 2 sessions; Foveola 2 in 1 session; P2 by Foveola 1, then Foveola 2");
}

/// Puts a timing that ended so before that of the trial which counts.
void add_earlier_timing(study::StudyRecords& records, std::uint32_t trial,
                        const std::string& outcome) {
  study::TrialRow row = records.trials[trial];
  row.counts = false;
  row.outcome = word_in(records, outcome);
  records.add_trial(row, std::vector<Value>(records.measures.size()));
}

TEST(DataQualityChecks, TrialsTimedAgainAreNamedButForThoseThatWereCutOff) {
  study::StudyRecords records = complete_study(3);
  records.sessions[2].state = "interrupted";
  (void)gaze_on_objects(records);  // numbers the trials
  EXPECT_EQ(check_on(records, "Retimed").value_text, "0 of 12 trials");
  add_earlier_timing(records, 1, "interrupted");
  EXPECT_EQ(check_on(records, "Retimed").verdict, Verdict::passed);
  add_earlier_timing(records, 2, "retimed");
  add_earlier_timing(records, 2, "paused");
  add_earlier_timing(records, 7, "retimed");
  add_earlier_timing(records, 13, "retimed");
  expect_check(check_on(records, "Retimed"), Verdict::flagged,
               "2 of 12 trials: P1, aula, fv (retimed, paused); P2, aula, vp (retimed)");
}

}  // namespace
}  // namespace foveola::analysis
