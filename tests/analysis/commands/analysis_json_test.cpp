#include "analysis/commands/analysis_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

nlohmann::json json_of(const study::StudyRecords& records) {
  AnalysisOutput output;
  output.report = "results/report.html";
  output.files = {"results/report.html"};
  output.tables = tabulate_study(records);
  output.comparisons = compare_methods(output.tables.set, {});
  return nlohmann::json::parse(analysis_json(output));
}

TEST(AnalysisJson, HasThePathsAndTheNumbersOfR) {
  const auto golden = golden_study();
  const nlohmann::json json = json_of(golden_study_records());
  EXPECT_EQ(json["report"], "results/report.html");
  EXPECT_EQ(json["baseline"], "od");
  EXPECT_EQ(json["participants"], 8);
  EXPECT_EQ(json["excluded"], 6);
  const nlohmann::json& fv_outline = json["geometric_means"].at(2);
  EXPECT_EQ(fv_outline["method"], "fv");
  EXPECT_GOLDEN(fv_outline["percent_of_baseline"]["value"].get<double>(),
                golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GOLDEN(fv_outline["percent_of_baseline"]["ci95"].at(1).get<double>(),
                golden.at("outline.fv.high_percent"));
  EXPECT_GOLDEN(json["scene_times"].at(0)["seconds"]["sd"].get<double>(),
                golden.at("outline.aula.od.sd_s"));
  EXPECT_GOLDEN(json["background"]["correlations"].at(1)["p_two_sided"].get<double>(),
                golden.at("outline.fv.p"));
}

TEST(AnalysisJson, SaysWhoseDataItShows) {
  study::StudyRecords records = complete_study(2);
  EXPECT_EQ(json_of(records)["participant_kind"], "human");
  EXPECT_TRUE(json_of(records)["data_notice"].is_null());
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const nlohmann::json json = json_of(records);
  EXPECT_EQ(json["participant_kind"], "simulated");
  EXPECT_EQ(json["data_notice"], "Simulated data");
  for (const char* table : {"scene_times", "geometric_means", "artifact_ratings"}) {
    for (const nlohmann::json& row : json[table]) {
      EXPECT_EQ(row["participant_kind"], "simulated") << table;
    }
  }
}

TEST(AnalysisJson, HasTheTests) {
  const auto golden = golden_study();
  const nlohmann::json json = json_of(golden_study_records());
  const nlohmann::json& fv = json["comparisons"].at(1);
  EXPECT_EQ(fv["measure"], "outline");
  EXPECT_EQ(fv["method"], "fv");
  EXPECT_EQ(fv["status"], "exploratory");
  EXPECT_GOLDEN(100.0 * fv["times"]["ratio"].get<double>(),
                golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_TRUE(fv["ratings"].is_null());
  EXPECT_EQ(fv["wilcoxon"]["exact"], true);
  EXPECT_GT(json["omnibus"].at(0)["anova"]["f"].get<double>(), 1.0);
  EXPECT_TRUE(json_of(complete_study(1))["comparisons"].at(0)["times"].is_null());
}

TEST(AnalysisJson, WhatDoesNotExistIsNull) {
  const nlohmann::json json = json_of(complete_study(1));
  EXPECT_TRUE(json["geometric_means"].at(0)["percent_of_baseline"].is_null());
  EXPECT_TRUE(json["geometric_means"].at(1)["percent_of_baseline"]["ci95"].is_null());
  EXPECT_TRUE(json["scene_times"].at(0)["seconds"]["sd"].is_null());
  EXPECT_TRUE(json["background"]["correlations"].at(0)["pearson_r"].is_null());
}

TEST(AnalysisJson, NamesThatAreNotUtf8DoNotBreakIt) {
  study::StudyRecords records = complete_study(1);
  records.protocol_name = "damaged \xff name";
  EXPECT_NO_THROW((void)json_of(records));
}

}  // namespace
}  // namespace foveola::analysis
