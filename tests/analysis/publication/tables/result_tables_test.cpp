#include "analysis/publication/tables/result_tables.h"

#include <algorithm>

#include "analysis/koskela2018/background.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

struct Results {
  StudyTables tables;
  std::vector<Table> all;

  std::vector<CsvRow> rows_of(const std::string& id) const {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Table& table) { return table.id == id; });
    return found == all.end() ? std::vector<CsvRow>{} : parse_csv(csv_of(*found), id);
  }
};

Results results_of(const study::StudyRecords& records) {
  Results results{tabulate_study(records), {}};
  const Background background = analyse_background(background_answers(records),
                                                   records.protocol.analysis, results.tables.set);
  const StudyTables& tables = results.tables;
  results.all = {times_by_scene(tables),    times_by_method(tables),
                 ratings_by_method(tables), rating_counts(tables),
                 exclusions(tables),        background_correlation(tables, background),
                 amended_sessions(tables)};
  return results;
}

TEST(ResultTables, AmendedSessionsAreListed) {
  study::StudyRecords records = complete_study(3);
  records.amended.push_back({"P2", {"0a1b", {"timing.timeout_s", "texts.rest"}, "title = 'x'"}});
  records.sessions[2].state = "interrupted";
  records.amended.push_back({"P3", {"2c3d", {}, "title = 'y'"}});
  EXPECT_THAT(results_of(records).rows_of("amended_sessions"),
              ElementsAre(ElementsAre("participant", "protocol_sha256", "changed_keys", "analysed",
                                      "participant_kind"),
                          ElementsAre("P2", "0a1b", "timing.timeout_s texts.rest", "TRUE", "human"),
                          ElementsAre("P3", "2c3d", "", "FALSE", "human")));
}

TEST(ResultTables, NumbersAreInFullPrecision) {
  const Results results = results_of(golden_study_records());
  const CsvRow row = results.rows_of("times_by_scene").at(2);
  const SceneTimes& times = results.tables.scene_times_of(outline_index, 0, 1);
  EXPECT_EQ(row.at(2), "vp");
  EXPECT_EQ(std::stod(row.at(4)), *times.seconds.mean);
  EXPECT_EQ(std::stod(row.at(8)), *times.percent_of_baseline.mean);
}

TEST(ResultTables, WhatDoesNotExistIsEmpty) {
  study::StudyRecords records = complete_study(1);
  records.protocol.analysis.primary = {{"outline", "vp", "od"}};
  const Results results = results_of(records);
  const CsvRow baseline_row = results.rows_of("times_by_scene").at(1);
  EXPECT_EQ(baseline_row.at(5), "");
  EXPECT_EQ(baseline_row.at(8), "");
  EXPECT_THAT(results.rows_of("background_correlation").at(1),
              ElementsAre("outline", "vp", "log_ratio", "graphics_3d+offline_rendering", "1", "0",
                          "", "", "", "", "", "", "", "", "", "", "", "human"));
}

TEST(ResultTables, AnExclusionHasItsOwnSessionsKind) {
  study::StudyRecords records = complete_study(3);
  records.sessions[1].kind = "simulated";
  const std::vector<CsvRow> rows = results_of(records).rows_of("exclusions");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows.at(1).at(0), "P2");
  EXPECT_EQ(rows.at(1).back(), "simulated");
}

TEST(ResultTables, ExclusionsAreListed) {
  const std::vector<CsvRow> rows = results_of(golden_study_records()).rows_of("exclusions");
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_THAT(rows.at(1), ElementsAre("P02", "aula", "vp", "", "no trial recorded", "human"));
}

TEST(ResultTables, CountsHaveTheProtocolsOwnPointsAndLabels) {
  study::StudyRecords records = complete_study(2);
  study::Question& rating = records.measures[artifacts_index].question;
  rating.kind = study::QuestionKind::choice;
  rating.labels.clear();
  rating.options = {{"a little", 0.5}, {"much", 3.0}};
  change_values(records, "artifacts", [](study::Value& value) { value = measured(0.5); });
  const Results results = results_of(records);
  const std::vector<CsvRow> counts = results.rows_of("rating_counts");
  ASSERT_EQ(counts.size(), 1U + 3U * 2U);
  EXPECT_THAT(counts.at(1), ElementsAre("artifacts", "od", "0.5", "a little", "4", "human"));
  EXPECT_THAT(counts.at(2), ElementsAre("artifacts", "od", "3", "much", "0", "human"));
  EXPECT_EQ(results.rows_of("ratings_by_method").at(1).at(3), "0.5");
}

TEST(ResultTables, TheOrderInWhichRowsAreStoredDoesNotMatter) {
  const study::StudyRecords records = golden_study_records();
  const Results forward = results_of(records);
  const Results other = results_of(reordered(records, 8));
  for (std::size_t i = 0; i < forward.all.size(); ++i) {
    EXPECT_EQ(csv_of(other.all[i]), csv_of(forward.all[i]));
  }
}

}  // namespace
}  // namespace foveola::analysis
