#include "analysis/publication/instrument_checks.h"

#include <algorithm>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/proportion.h"
#include "renderer/base/csv.h"
#include "renderer/base/random.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

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

const InstrumentCheck& check_of(const InstrumentReport& report, const std::string& name) {
  const auto found = std::find_if(
      report.checks.begin(), report.checks.end(),
      [&](const InstrumentCheck& check) { return check.name.find(name) != std::string::npos; });
  if (found == report.checks.end()) {
    throw std::out_of_range(name);
  }
  return *found;
}

TEST(InstrumentChecks, AGoodInstrumentPasses) {
  study::InstrumentRecords instrument;
  instrument.frames = {good_frames("P1"), good_frames("P2")};
  instrument.gaze_runs = {{"P1", 1, 5.0, 0.1, 0.0, false},
                          {"P1", 2, 0.8, 0.1, 0.0, true},
                          {"P2", 1, 0.9, 0.1, 0.0, true}};
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(2)), instrument);
  for (const char* name :
       {"refresh", "valid gaze", "Latency", "mark upon it", "Validation", "People"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::passed) << name;
  }
  EXPECT_THAT(check_of(report, "Validation").found, HasSubstr("0.90° at most"));
}

TEST(InstrumentChecks, WhatWasMissedIsFlaggedWithWhoMissedItMost) {
  study::InstrumentRecords instrument;
  instrument.frames = {good_frames("P1"), good_frames("P2")};
  instrument.frames[1].late = 500;
  instrument.frames[1].untracked = 2000;
  instrument.frames[1].mean_gaze_age_s = 0.09;
  instrument.frames[1].longest_mark_after_frame_s = 0.5;
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(2)), instrument);
  for (const char* name : {"refresh", "valid gaze", "Latency", "mark upon it"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::flagged) << name;
    EXPECT_THAT(check_of(report, name).found, HasSubstr("participant P2; 1 above the limit"));
  }
}

TEST(InstrumentChecks, WhoIsNotAnalysedDoesNotCount) {
  study::InstrumentRecords instrument;
  instrument.frames = {good_frames("P1"), good_frames("X")};
  instrument.frames[1].late = 9000;
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(1)), instrument);
  EXPECT_EQ(check_of(report, "refresh").verdict, Verdict::passed);
}

TEST(InstrumentChecks, WhatWasNotRecordedIsNotCalledGood) {
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(2)), {});
  for (const char* name : {"refresh", "valid gaze", "Latency", "Validation"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::unknown) << name;
  }
  EXPECT_TRUE(report.reactions.empty());
}

TEST(InstrumentChecks, OnlyTheLastValidationCounts) {
  study::InstrumentRecords instrument;
  instrument.gaze_runs = {{"P1", 1, 0.5, 0.1, 0.0, true}, {"P1", 2, 4.0, 0.1, 0.4, false}};
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(1)), instrument);
  EXPECT_EQ(check_of(report, "Validation").verdict, Verdict::flagged);
}

TEST(InstrumentChecks, AMethodThatAlwaysComesFirstIsFlagged) {
  study::StudyRecords records = complete_study(8);
  for (study::TrialRow& row : records.trials) {
    row.method_position = row.method == "od" ? 0 : row.method == "vp" ? 1 : 2;
  }
  EXPECT_EQ(check_of(check_instrument(tabulate_study(records), {}), "order").verdict,
            Verdict::flagged);
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = (trial % 3 + trial / 3) % 3;
    ++trial;
  }
  const InstrumentCheck balanced = check_of(check_instrument(tabulate_study(records), {}), "order");
  EXPECT_EQ(balanced.verdict, Verdict::passed);
  EXPECT_THAT(balanced.found, HasSubstr("5 to 6 times"));
}

// Each participant's methods are permuted within the scene, so counts vary less than free ones:
// the check's level is kept only if it takes that into account.
TEST(InstrumentChecks, OneRandomDesignInAHundredIsFlagged) {
  constexpr std::size_t designs = 3000;
  StudyTables tables = tabulate_study(complete_study(40));
  const std::size_t methods = tables.set.methods.size();
  Pcg32 generator(26, 1);
  std::size_t flagged = 0;
  for (std::size_t design = 0; design < designs; ++design) {
    std::vector<int> places = {0, 1, 2};
    for (std::size_t i = 0; i < tables.set.cells.size(); ++i) {
      if (i % methods == 0) {
        shuffle(std::span(places), generator);
      }
      tables.set.cells[i].method_position = places[i % methods];
    }
    flagged += check_of(check_instrument(tables, {}), "order").verdict == Verdict::flagged ? 1 : 0;
  }
  const Interval share = clopper_pearson(flagged, designs, 0.999);
  EXPECT_LE(share.low, 0.01) << flagged;
  EXPECT_GE(share.high, 0.01) << flagged;
}

TEST(InstrumentChecks, ASceneWithAMissingTrialSaysNothingOfTheOrder) {
  study::StudyRecords records = complete_study(6);
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = (trial % 3 + trial / 3) % 3;
    ++trial;
  }
  const InstrumentCheck whole = check_of(check_instrument(tabulate_study(records), {}), "order");
  EXPECT_THAT(whole.found, HasSubstr("each method 4 to 4 times"));
  records.trials.pop_back();
  const InstrumentCheck less = check_of(check_instrument(tabulate_study(records), {}), "order");
  EXPECT_THAT(less.found, HasSubstr("each method 3 to 4 times"));
}

TEST(InstrumentChecks, SimulatedSessionsAreFlagged) {
  study::StudyRecords records = complete_study(3);
  records.sessions[0].kind = "simulated";
  EXPECT_EQ(check_of(check_instrument(tabulate_study(records), {}), "People").verdict,
            Verdict::flagged);
}

TEST(InstrumentChecks, MarksAreHeldAgainstTheReactionFloor) {
  study::StudyRecords records = complete_study(2);
  trial_of(records, "P1", "aula", "fv").outline_s = 0.2;
  study::InstrumentRecords instrument;
  instrument.reactions = {
      {"P1", 0.3, false}, {"P1", 0.2, false}, {"P1", 0.4, false}, {"P1", -0.05, true}};
  const InstrumentReport report = check_instrument(tabulate_study(records), instrument);
  ASSERT_EQ(report.reactions.size(), 1U);
  const ReactionFloor& floor = report.reactions[0];
  EXPECT_EQ(floor.presses, 3U);
  EXPECT_EQ(floor.false_starts, 1U);
  EXPECT_DOUBLE_EQ(floor.median_s.value(), 0.3);
  EXPECT_EQ(floor.marks, 12U);
  EXPECT_EQ(floor.within_floor, 1U);
}

TEST(InstrumentChecks, FilesSayWhoTookPart) {
  study::InstrumentRecords instrument;
  instrument.reactions = {{"P1", 0.3, false}};
  const InstrumentReport report = check_instrument(tabulate_study(complete_study(1)), instrument);
  for (const std::string& text :
       {instrument_csv(report, "pilot"), reactions_csv(report, "pilot")}) {
    const std::vector<CsvRow> rows = parse_csv(text, "table");
    EXPECT_THAT(rows, Each(SizeIs(rows.front().size())));
    EXPECT_EQ(rows.front().back(), "participant_kind");
    EXPECT_EQ(rows.back().back(), "pilot");
  }
}

}  // namespace
}  // namespace foveola::analysis
