#include "analysis/publication/data_quality_checks.h"

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

const DataQualityCheck& check_of(const DataQualityReport& report, const std::string& name) {
  const auto found = std::find_if(
      report.checks.begin(), report.checks.end(),
      [&](const DataQualityCheck& check) { return check.name.find(name) != std::string::npos; });
  if (found == report.checks.end()) {
    throw std::out_of_range(name);
  }
  return *found;
}

TEST(DataQualityChecks, GoodDataPass) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("P2")};
  quality.gaze_runs = {{"P1", 1, 5.0, 0.1, 0.0, false},
                       {"P1", 2, 0.8, 0.1, 0.0, true},
                       {"P2", 1, 0.9, 0.1, 0.0, true}};
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(2)), quality);
  for (const char* name :
       {"refresh", "valid gaze", "Latency", "mark upon it", "Validation", "People"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::passed) << name;
  }
  EXPECT_THAT(check_of(report, "Validation").found, HasSubstr("0.90° at most"));
}

TEST(DataQualityChecks, WhatWasMissedIsFlaggedWithWhoMissedItMost) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("P2")};
  quality.frames[1].late = 500;
  quality.frames[1].untracked = 2000;
  quality.frames[1].mean_gaze_age_s = 0.09;
  quality.frames[1].longest_mark_after_frame_s = 0.5;
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(2)), quality);
  for (const char* name : {"refresh", "valid gaze", "Latency", "mark upon it"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::flagged) << name;
    EXPECT_THAT(check_of(report, name).found, HasSubstr("participant P2; 1 above the limit"));
  }
}

TEST(DataQualityChecks, WhoIsNotAnalysedDoesNotCount) {
  study::DataQualityRecords quality;
  quality.frames = {good_frames("P1"), good_frames("X")};
  quality.frames[1].late = 9000;
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(1)), quality);
  EXPECT_EQ(check_of(report, "refresh").verdict, Verdict::passed);
}

TEST(DataQualityChecks, WhatWasNotRecordedIsNotCalledGood) {
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(2)), {});
  for (const char* name : {"refresh", "valid gaze", "Latency", "Validation"}) {
    EXPECT_EQ(check_of(report, name).verdict, Verdict::unknown) << name;
  }
  EXPECT_TRUE(report.reactions.empty());
}

TEST(DataQualityChecks, OnlyTheLastValidationCounts) {
  study::DataQualityRecords quality;
  quality.gaze_runs = {{"P1", 1, 0.5, 0.1, 0.0, true}, {"P1", 2, 4.0, 0.1, 0.4, false}};
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(1)), quality);
  EXPECT_EQ(check_of(report, "Validation").verdict, Verdict::flagged);
}

TEST(DataQualityChecks, AMethodThatAlwaysComesFirstIsFlagged) {
  study::StudyRecords records = complete_study(8);
  for (study::TrialRow& row : records.trials) {
    row.method_position = row.method == "od" ? 0 : row.method == "vp" ? 1 : 2;
  }
  EXPECT_EQ(check_of(check_data_quality(tabulate_study(records), {}), "order").verdict,
            Verdict::flagged);
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = (trial % 3 + trial / 3) % 3;
    ++trial;
  }
  const DataQualityCheck balanced =
      check_of(check_data_quality(tabulate_study(records), {}), "order");
  EXPECT_EQ(balanced.verdict, Verdict::passed);
  EXPECT_THAT(balanced.found, HasSubstr("5 to 6 times"));
}

// Each participant's methods are permuted within the scene, so counts vary less than free ones:
// the check's level is kept only if it takes that into account.
TEST(DataQualityChecks, OneRandomDesignInAHundredIsFlagged) {
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
    flagged +=
        check_of(check_data_quality(tables, {}), "order").verdict == Verdict::flagged ? 1 : 0;
  }
  const Interval share = clopper_pearson(flagged, designs, 0.999);
  EXPECT_LE(share.low, 0.01) << flagged;
  EXPECT_GE(share.high, 0.01) << flagged;
}

TEST(DataQualityChecks, ASceneWithAMissingTrialSaysNothingOfTheOrder) {
  study::StudyRecords records = complete_study(6);
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = (trial % 3 + trial / 3) % 3;
    ++trial;
  }
  const DataQualityCheck whole = check_of(check_data_quality(tabulate_study(records), {}), "order");
  EXPECT_THAT(whole.found, HasSubstr("each method 4 to 4 times"));
  records.trials.pop_back();
  const DataQualityCheck less = check_of(check_data_quality(tabulate_study(records), {}), "order");
  EXPECT_THAT(less.found, HasSubstr("each method 3 to 4 times"));
}

TEST(DataQualityChecks, SimulatedSessionsAreFlagged) {
  study::StudyRecords records = complete_study(3);
  records.sessions[0].kind = "simulated";
  EXPECT_EQ(check_of(check_data_quality(tabulate_study(records), {}), "People").verdict,
            Verdict::flagged);
}

TEST(DataQualityChecks, MarksAreHeldAgainstTheReactionFloor) {
  study::StudyRecords records = complete_study(2);
  trial_of(records, "P1", "aula", "fv").outline_s = 0.2;
  study::DataQualityRecords quality;
  quality.reactions = {
      {"P1", 0.3, false}, {"P1", 0.2, false}, {"P1", 0.4, false}, {"P1", -0.05, true}};
  const DataQualityReport report = check_data_quality(tabulate_study(records), quality);
  ASSERT_EQ(report.reactions.size(), 1U);
  const ReactionFloor& floor = report.reactions[0];
  EXPECT_EQ(floor.presses, 3U);
  EXPECT_EQ(floor.false_starts, 1U);
  EXPECT_DOUBLE_EQ(floor.median_s.value(), 0.3);
  EXPECT_EQ(floor.marks, 12U);
  EXPECT_EQ(floor.within_floor, 1U);
}

TEST(DataQualityChecks, FilesSayWhoTookPart) {
  study::DataQualityRecords quality;
  quality.reactions = {{"P1", 0.3, false}};
  const DataQualityReport report = check_data_quality(tabulate_study(complete_study(1)), quality);
  for (const std::string& text :
       {data_quality_csv(report, "pilot"), reactions_csv(report, "pilot")}) {
    const std::vector<CsvRow> rows = parse_csv(text, "table");
    EXPECT_THAT(rows, Each(SizeIs(rows.front().size())));
    EXPECT_EQ(rows.front().back(), "participant_kind");
    EXPECT_EQ(rows.back().back(), "pilot");
  }
}

}  // namespace
}  // namespace foveola::analysis
