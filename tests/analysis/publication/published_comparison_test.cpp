#include "analysis/publication/published_comparison.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/csv.h"
#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

/// What a made-up paper says of one scene and one question.
PublishedTables made_up_paper() {
  PublishedTables paper;
  paper.background = {{"offline_rendering", 2.5, 1.0}, {"age", std::nullopt, std::nullopt}};
  paper.times = {{"aula", "", Mark::outline, "od", 12.0, 3.0},
                 {"unseen", "barn", Mark::outline, "fv", 10.0, std::nullopt},
                 {"elsewhere", "nowhere", Mark::material, "fv", 10.0, 2.0}};
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
      compare_with_published(compared.tables, records.background, made_up_paper(), ranges);
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
  const SceneTimes& aula = compared.tables.scene_times_of(Mark::outline, 0, 0);
  EXPECT_EQ(own.study, aula.seconds.mean);
  EXPECT_DOUBLE_EQ(difference_of(own).value(), *aula.seconds.mean - 12.0);
  EXPECT_EQ(own.unit, "s");

  const SceneTimes& barn = compared.tables.scene_times_of(Mark::outline, 1, 2);
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
  records.sessions.push_back({"Q", "pilot", "completed"});
  records.background.push_back({"Q", "offline_rendering", 1.0});
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
            compared.tables.method_times_of(Mark::material, 2).percent_of_baseline->value);
}

TEST(PublishedComparison, AnotherBaselineIsNotComparedWithOd) {
  study::StudyRecords records = complete_study(3);
  records.methods = {"vp", "od", "fv"};
  for (const ComparedCell& cell : compare(records).cells) {
    EXPECT_TRUE(cell.source == "Table 1" || !cell.study);
  }
}

TEST(PublishedComparison, FilesSayThatDataAreSimulated) {
  study::StudyRecords records = complete_study(3);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const Compared compared = compare(records);
  const std::vector<CsvRow> rows =
      parse_csv(comparison_csv(compared.tables, compared.cells), "comparison");
  EXPECT_THAT(rows, Each(SizeIs(14)));
  EXPECT_EQ(rows.front().back(), "participant_kind");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].back(), "simulated");
  }
  const std::string html = comparison_html(compared.tables, compared.cells);
  EXPECT_THAT(html, HasSubstr("<td>not at hand</td>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"notice\" role=\"note\">Simulated data"));
  EXPECT_THAT(html, HasSubstr("<caption><span class=\"tag\">Simulated data</span>"));
}

TEST(PublishedComparison, AMissingStudyIsAnErrorThatNamesIt) {
  EXPECT_THAT([] { (void)report_published_comparison("none.sqlite", "results"); },
              testing::ThrowsMessage<Error>(HasSubstr("none.sqlite")));
}

}  // namespace
}  // namespace foveola::analysis
