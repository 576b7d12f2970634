#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/dataset/trial_data.h"
#include "analysis/publication/tables/result_tables.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

nlohmann::json json_for(const study::StudyRecords& records) {
  AnalysisOutput output;
  output.report = "results/report.html";
  output.files = {"results/report.html"};
  output.tables = tabulate_study(records);
  const StudyTables& tables = output.tables;
  output.background =
      analyse_background(background_answers(records), records.protocol.analysis, output.tables.set);
  output.comparisons = compare_methods(tables.set, records.protocol.analysis);
  output.checks = check_data_quality(tables, {}, records);
  output.results =
      result_tables(records, tables, output.background, output.comparisons, output.checks);
  // What R is to fit is not data.
  std::erase_if(output.results, [](const Table& table) { return table.id == "models_plan"; });
  output.results.push_back(
      {"trials_long", "trial", columns_in(trial_columns(records, tables.set)), {}});
  return nlohmann::json::parse(analysis_json(output));
}

TEST(AnalysisJson, HasThePathsAndTheNumbersOfR) {
  const auto golden = golden_study();
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  const nlohmann::json json = json_for(records);
  EXPECT_EQ(json["report"], "results/report.html");
  EXPECT_EQ(json["baseline"], "od");
  EXPECT_EQ(json["participants"], 8);
  EXPECT_EQ(json["excluded"], 6);
  const nlohmann::json& tables = json["tables"];
  const nlohmann::json& fv_outline = tables["times_by_method"].at(2);
  EXPECT_EQ(fv_outline["method"], "fv");
  EXPECT_GOLDEN(fv_outline["geometric_mean_percent_of_baseline"].get<double>(),
                golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GOLDEN(fv_outline["ci95_high_percent_of_baseline"].get<double>(),
                golden.at("outline.fv.high_percent"));
  EXPECT_GOLDEN(tables["times_by_scene"].at(0)["sd_s"].get<double>(),
                golden.at("outline.aula.od.sd_s"));
  EXPECT_GOLDEN(tables["background_correlation"].at(0)["p_two_sided"].get<double>(),
                golden.at("outline.fv.log_p"));
}

TEST(AnalysisJson, SaysWhoseDataItShows) {
  study::StudyRecords records = complete_study(2);
  EXPECT_EQ(json_for(records)["participant_kind"], "human");
  EXPECT_TRUE(json_for(records)["data_notice"].is_null());
  const nlohmann::json json = json_for(of_kind(records, "simulated"));
  EXPECT_EQ(json["participant_kind"], "simulated");
  EXPECT_EQ(json["data_notice"], "Simulated data");
  for (const auto& [name, rows] : json["tables"].items()) {
    for (const nlohmann::json& row : rows) {
      EXPECT_EQ(row["participant_kind"], "simulated") << name;
    }
  }
}

TEST(AnalysisJson, SaysWhatWasMeasured) {
  study::StudyRecords records = complete_study(1);
  records.measures[artifacts_index].question.labels = {"keine", "alle"};
  const nlohmann::json measures = json_for(records)["measures"];
  ASSERT_EQ(measures.size(), 3U);
  EXPECT_EQ(measures.at(0)["id"], "outline");
  EXPECT_EQ(measures.at(0)["kind"], "time");
  EXPECT_EQ(measures.at(0)["unit"], "s");
  EXPECT_EQ(measures.at(2)["kind"], "rating");
  EXPECT_EQ(measures.at(2)["scale"], "1 keine to 5 alle");
}

TEST(AnalysisJson, HasTheTests) {
  const nlohmann::json tables = json_for(golden_study_records())["tables"];
  EXPECT_GOLDEN(tables["comparisons"].at(1)["complete_ratio_percent"].get<double>(),
                golden_study().at("outline.fv.geometric_mean_percent"));
  const nlohmann::json alone = json_for(complete_study(1))["tables"]["comparisons"].at(0);
  EXPECT_TRUE(alone["ratio_percent"].is_number());
  EXPECT_TRUE(alone["ci95_low_percent"].is_null());
}

TEST(AnalysisJson, TablesThatAreWrittenRowByRowAreInTheirFilesOnly) {
  EXPECT_FALSE(json_for(complete_study(1))["tables"].contains("trials_long"));
}

TEST(AnalysisJson, NamesThatAreNotUtf8DoNotBreakIt) {
  study::StudyRecords records = complete_study(1);
  records.protocol.name = "damaged \xff name";
  records.scenes[0] = "damaged \xff scene";
  EXPECT_NO_THROW((void)json_for(records));
}

}  // namespace
}  // namespace foveola::analysis
