#include "analysis/koskela2018/published_comparison.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

/// What a made-up paper says of one scene and one question.
PublishedTables made_up_paper() {
  PublishedTables paper;
  paper.background = {{"offline_rendering", 2.5, 1.0}, {"age", std::nullopt, std::nullopt}};
  paper.times = {{"aula", "", "outline", "od", 12.0, 3.0},
                 {"unseen", "barn", "outline", "fv", 10.0, std::nullopt},
                 {"elsewhere", "nowhere", "material", "fv", 10.0, 2.0}};
  return paper;
}

const std::vector<PublishedMean> ranges = {{"vp", {31, 33}}, {"fv", {9, 12}}};

struct Compared {
  StudyTables tables;
  std::vector<ComparedCell> cells;
};

Compared compare(const study::StudyRecords& records) {
  Compared compared{tabulate_study(records), {}};
  compared.cells =
      compare_with_published(compared.tables, background_answers(records), made_up_paper(), ranges);
  return compared;
}

const ComparedCell& cell_of(const Compared& compared, const std::string& row,
                            const std::string& quantity, const std::string& reading = "",
                            const std::string& mark = "", const std::string& method = "") {
  const auto found =
      std::find_if(compared.cells.begin(), compared.cells.end(), [&](const ComparedCell& cell) {
        return cell.row == row && cell.quantity == quantity && cell.reading == reading &&
               (mark.empty() || cell.mark == mark) && (method.empty() || cell.method == method);
      });
  if (found == compared.cells.end()) {
    throw std::out_of_range("no cell " + row);
  }
  return *found;
}

TEST(PublishedComparison, ASceneIsComparedWithItselfOrItsCounterpart) {
  const Compared compared = compare(complete_study(5));
  const ComparedCell& own = cell_of(compared, "aula", "mean");
  EXPECT_EQ(own.own_row, "aula");
  const SceneTimes& aula = compared.tables.scene_times_of(outline_index, 0, 0);
  EXPECT_EQ(own.study, aula.seconds.mean);
  EXPECT_DOUBLE_EQ(difference_of(own).value(), *aula.seconds.mean - 12.0);
  EXPECT_EQ(own.unit, "s");

  const SceneTimes& barn = compared.tables.scene_times_of(outline_index, 1, 2);
  const ComparedCell& ratios = cell_of(compared, "unseen", "mean", "own ratios");
  EXPECT_EQ(ratios.own_row, "barn");
  EXPECT_EQ(ratios.study, barn.percent_of_baseline.mean);
  EXPECT_EQ(cell_of(compared, "unseen", "mean", "ratio of means").study,
            barn.of_baseline_mean.mean_percent);
  EXPECT_EQ(cell_of(compared, "unseen", "sd", "ratio of means").study,
            barn.of_baseline_mean.sd_percent_points);
  EXPECT_EQ(cell_of(compared, "unseen", "sd", "ratio of means").unit, "percentage points");
}

TEST(PublishedComparison, WhatIsMissingIsSaidOfEachCell) {
  const Compared compared = compare(complete_study(5));
  EXPECT_EQ(what_is_missing(cell_of(compared, "aula", "mean")), "");
  EXPECT_EQ(what_is_missing(cell_of(compared, "unseen", "sd", "own ratios")),
            "the published number is not at hand");
  EXPECT_EQ(what_is_missing(cell_of(compared, "elsewhere", "mean", "own ratios")),
            "this study has no such number");
  EXPECT_EQ(what_is_missing(cell_of(compared, "age", "mean")),
            "the published number is not at hand, and this study has none");
  for (const ComparedCell& cell : compared.cells) {
    EXPECT_EQ(difference_of(cell).has_value(), what_is_missing(cell).empty());
  }
}

TEST(PublishedComparison, BackgroundIsOfTheParticipantsThatAreAnalysed) {
  study::StudyRecords records = complete_study(4);
  const double plain = cell_of(compare(records), "offline_rendering", "mean").study.value();
  EXPECT_DOUBLE_EQ(plain, (2.0 + 3.0 + 4.0 + 5.0) / 4.0);
  records.sessions.push_back({"Q", "pilot", "completed", {}, {}});
  add_answer(records, "Q", "background", "offline_rendering", 1.0);
  EXPECT_EQ(cell_of(compare(records), "offline_rendering", "mean").study, plain);
}

TEST(PublishedComparison, InsideARangeThereIsNoDifference) {
  ComparedCell cell;
  cell.published = Interval{9, 12};
  cell.study = 10.0;
  EXPECT_EQ(difference_of(cell), 0.0);
  cell.study = 14.0;
  EXPECT_EQ(difference_of(cell), 2.0);
  cell.study = 8.5;
  EXPECT_EQ(difference_of(cell), -0.5);
}

TEST(PublishedComparison, TheRangesOfTheTextAreComparedWithGeometricMeans) {
  const Compared compared = compare(complete_study(5));
  const ComparedCell& fv =
      cell_of(compared, "all scenes", "mean", "geometric mean", "material", "fv");
  EXPECT_EQ(fv.published->high, 12.0);
  EXPECT_EQ(fv.study,
            compared.tables.method_times_of(material_index, 2).percent_of_baseline->value);
}

TEST(PublishedComparison, AnotherBaselineIsNotComparedWithOd) {
  study::StudyRecords records = complete_study(3);
  records.methods = {"vp", "od", "fv"};
  for (study::TrialRow& row : records.trials) {
    row.method = row.method == 2 ? 2 : row.method == 0 ? 1 : 0;
  }
  for (const ComparedCell& cell : compare(records).cells) {
    EXPECT_TRUE(cell.source == "Table 1" || !cell.study);
  }
}

}  // namespace
}  // namespace foveola::analysis
