#include "analysis/publication/table_files.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/csv.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

std::vector<CsvRow> table(const StudyTables& tables, const std::string& name) {
  const std::vector<TextFile> files = table_files(tables);
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const TextFile& file) { return file.name == name; });
  return found == files.end() ? std::vector<CsvRow>{} : parse_csv(found->content, name);
}

TEST(TableFiles, ColumnsAreFixedAndNameTheirUnits) {
  const StudyTables tables = tabulate_study(golden_study_records());
  EXPECT_THAT(
      table(tables, "table2_times.csv").at(0),
      ElementsAre("mark", "scene", "method", "n", "mean_s", "sd_s", "median_s", "n_pairs",
                  "mean_percent_of_baseline", "sd_percent_of_baseline", "ratio_of_means_percent",
                  "sd_over_baseline_mean_percent", "censored", "missing", "participant_kind"));
  EXPECT_THAT(table(tables, "figure5_geometric_means.csv").at(0),
              ElementsAre("mark", "method", "n", "geometric_mean_s", "ci95_low_s", "ci95_high_s",
                          "geometric_mean_percent_of_baseline", "ci95_low_percent_of_baseline",
                          "ci95_high_percent_of_baseline", "participant_kind"));
  EXPECT_THAT(table(tables, "figure6_artifact_ratings.csv").at(0),
              ElementsAre("method", "n", "mean", "sd", "median", "count_1", "count_2", "count_3",
                          "count_4", "count_5", "missing", "participant_kind"));
  EXPECT_THAT(
      table(tables, "background_correlation.csv").at(0),
      ElementsAre("mark", "method", "background_questions", "n", "pearson_r", "t", "p_two_sided",
                  "ci95_low_r", "ci95_high_r", "spearman_rho", "t_rho", "p_rho", "ci95_low_rho",
                  "ci95_high_rho", "p_rho_exact", "participant_kind"));
  EXPECT_THAT(
      table(tables, "exclusions.csv").at(0),
      ElementsAre("participant", "scene", "method", "measure", "reason", "participant_kind"));
}

TEST(TableFiles, AmendedSessionsAreListed) {
  study::StudyRecords records = complete_study(3);
  records.amended.push_back({"P2", {"0a1b", {"timing.timeout_s", "texts.rest"}, "title = 'x'"}});
  records.sessions[2].state = "interrupted";
  records.amended.push_back({"P3", {"2c3d", {}, "title = 'y'"}});
  EXPECT_THAT(table(tabulate_study(records), "amended_sessions.csv"),
              ElementsAre(ElementsAre("participant", "protocol_sha256", "changed_keys", "analysed",
                                      "participant_kind"),
                          ElementsAre("P2", "0a1b", "timing.timeout_s texts.rest", "true", "human"),
                          ElementsAre("P3", "2c3d", "", "false", "human")));
}

TEST(TableFiles, EveryRowHasEveryColumn) {
  for (const int participants : {1, 2, 4}) {
    const StudyTables tables = tabulate_study(complete_study(participants));
    for (const TextFile& file : table_files(tables)) {
      const std::vector<CsvRow> rows = parse_csv(file.content, file.name);
      EXPECT_THAT(rows, Each(SizeIs(rows.front().size()))) << file.name;
    }
  }
}

TEST(TableFiles, NumbersAreInFullPrecision) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const CsvRow row = table(tables, "table2_times.csv").at(2);
  const SceneTimes& times = tables.scene_times_of(Mark::outline, 0, 1);
  EXPECT_EQ(row.at(2), "vp");
  EXPECT_EQ(std::stod(row.at(4)), *times.seconds.mean);
  EXPECT_EQ(std::stod(row.at(8)), *times.percent_of_baseline.mean);
}

TEST(TableFiles, WhatDoesNotExistIsEmpty) {
  const StudyTables tables = tabulate_study(complete_study(1));
  const CsvRow baseline_row = table(tables, "table2_times.csv").at(1);
  EXPECT_EQ(baseline_row.at(5), "");
  EXPECT_EQ(baseline_row.at(8), "");
  EXPECT_THAT(table(tables, "background_correlation.csv").at(1),
              ElementsAre("outline", "vp", "graphics_3d+offline_rendering", "1", "", "", "", "", "",
                          "", "", "", "", "", "", "human"));
}

TEST(TableFiles, SimulatedParticipantsAreSaidToBe) {
  study::StudyRecords records = complete_study(2);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const std::vector<CsvRow> rows = table(tabulate_study(records), "table2_times.csv");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].back(), "simulated");
  }
}

TEST(TableFiles, EveryTableSaysWhoseDataItShows) {
  study::StudyRecords records = complete_study(3);
  for (const char* kind : {"simulated", "pilot", "human"}) {
    for (study::SessionRow& session : records.sessions) {
      session.kind = kind;
    }
    records.trials[0].artifact_rating.reset();
    records.amended = {{"P1", {"0a1b", {"texts.rest"}, "title = 'x'"}}};
    for (const TextFile& file : table_files(tabulate_study(records))) {
      const std::vector<CsvRow> rows = parse_csv(file.content, file.name);
      ASSERT_GT(rows.size(), 1U) << file.name;
      EXPECT_EQ(rows.front().back(), "participant_kind") << file.name;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].back(), kind) << file.name;
      }
    }
  }
}

TEST(TableFiles, AnExclusionHasItsOwnSessionsKind) {
  study::StudyRecords records = complete_study(3);
  records.sessions[1].kind = "simulated";
  const std::vector<CsvRow> rows = table(tabulate_study(records), "exclusions.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows.at(1).at(0), "P2");
  EXPECT_EQ(rows.at(1).back(), "simulated");
}

TEST(TableFiles, ExclusionsAreListed) {
  const std::vector<CsvRow> rows = table(tabulate_study(golden_study_records()), "exclusions.csv");
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_THAT(rows.at(1), ElementsAre("P02", "aula", "vp", "", "no trial recorded", "human"));
}

}  // namespace
}  // namespace foveola::analysis
