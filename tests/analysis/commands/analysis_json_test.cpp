#include "analysis/commands/analysis_json.h"

#include <cmath>

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
  EXPECT_GOLDEN(json["background"]["correlations"].at(1)["pearson"]["p_two_sided"].get<double>(),
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

TEST(AnalysisJson, HasTheCorrelationsOfBackground) {
  study::StudyRecords records = golden_study_records();
  const BackgroundCorrelation expected = tabulate_study(records).background_correlations.at(1);
  const nlohmann::json background = json_of(records)["background"];
  const nlohmann::json& found = background["correlations"].at(1);
  EXPECT_EQ(found["spearman"]["r"], expected.spearman->r);
  EXPECT_EQ(found["spearman"]["ci95"].at(0), expected.spearman->interval->low);
  EXPECT_EQ(found["spearman"]["exact"], true);
  EXPECT_EQ(found["pearson"]["exact"], false);
  EXPECT_EQ(background["scale_as_published"], true);
  EXPECT_EQ(background["answers"].size(), 3U);
}

TEST(AnalysisJson, HasOrderEffectsAndEffectSizes) {
  study::StudyRecords records = golden_study_records();
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    records.trials[i].method_position = static_cast<int>((i + i / 9) % 3);
  }
  const Comparisons expected = compare_methods(tabulate_study(records).set, {});
  const nlohmann::json json = json_of(records);
  ASSERT_EQ(json["order_effects"].size(), 4U);
  EXPECT_EQ(json["order_effects"].at(1)["change_percent"]["d_z"],
            expected.order.at(1).change_per_step->d_z);
  const nlohmann::json& anova = json["omnibus"].at(0)["anova"];
  EXPECT_EQ(anova["partial_eta_squared"], expected.omnibus.at(0).variance->partial_eta_squared);
  EXPECT_EQ(anova["p_huynh_feldt"], expected.omnibus.at(0).variance->p_huynh_feldt);
  const MethodComparison& fv = expected.methods.at(1);
  EXPECT_DOUBLE_EQ(json["comparisons"].at(1)["pseudo_median"]["value"].get<double>(),
                   std::exp(fv.pseudo_median->value));
}

TEST(AnalysisJson, HasNoEstimateFromRightCensoredTimesButTheirCount) {
  study::StudyRecords records = complete_study(6);
  trial_of(records, "P1", "aula", "od").outline_censored = true;
  const nlohmann::json json = json_of(records);
  EXPECT_FALSE(json["comparisons"].at(0).contains("times_with_bounds"));
  EXPECT_EQ(json["scene_times"].at(0)["censored"], 1);
}

TEST(AnalysisJson, HasEquivalenceInTheMarginsUnit) {
  AnalysisOutput output;
  output.tables = tabulate_study(golden_study_records());
  study::AnalysisPlan plan;
  plan.equivalence_margins = {{"outline", 1.5}, {"artifacts", 0.5}};
  output.comparisons = compare_methods(output.tables.set, plan);
  const nlohmann::json rows = nlohmann::json::parse(analysis_json(output))["comparisons"];
  const MethodComparison& outline = output.comparisons.methods.front();
  const MethodComparison& artifacts = output.comparisons.methods.back();
  EXPECT_EQ(rows.front()["equivalence"]["margin"], 1.5);
  EXPECT_DOUBLE_EQ(rows.front()["equivalence"]["interval"].at(0).get<double>(),
                   std::exp(outline.equivalent->interval.low));
  EXPECT_EQ(rows.back()["equivalence"]["interval"].at(1), artifacts.equivalent->interval.high);
}

TEST(AnalysisJson, HasTheChecksOfDataQualityAndTheirFigures) {
  AnalysisOutput output;
  output.tables = tabulate_study(complete_study(2));
  study::DataQualityRecords quality;
  quality.frames = {{.participant = "P1", .frames = 100, .late = 7, .mean_gaze_age_s = 0.012}};
  quality.reactions = {{"P2", 0.25, false}};
  output.checks = check_data_quality(output.tables, quality);
  const nlohmann::json found = nlohmann::json::parse(analysis_json(output))["data_quality"];
  EXPECT_EQ(found["checks"].size(), output.checks.checks.size());
  EXPECT_EQ(found["checks"].at(1)["verdict"], "flagged");
  EXPECT_EQ(found["latency"].at(0)["late_frames"], 7);
  EXPECT_EQ(found["latency"].at(0)["mean_gaze_age_s"], 0.012);
  EXPECT_EQ(found["reaction_times"].at(0)["median_s"], 0.25);
}

TEST(AnalysisJson, SaysWhichSessionsWereAmended) {
  study::StudyRecords records = complete_study(2);
  records.amended.push_back({"P2", {"0a1b", {"texts.rest"}, "title = 'x'"}});
  const nlohmann::json found = json_of(records)["amended_sessions"];
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.at(0)["participant"], "P2");
  EXPECT_EQ(found.at(0)["changed_keys"], nlohmann::json::array({"texts.rest"}));
  EXPECT_EQ(found.at(0)["analysed"], true);
}

TEST(AnalysisJson, WhatDoesNotExistIsNull) {
  const nlohmann::json json = json_of(complete_study(1));
  EXPECT_TRUE(json["geometric_means"].at(0)["percent_of_baseline"].is_null());
  EXPECT_TRUE(json["geometric_means"].at(1)["percent_of_baseline"]["ci95"].is_null());
  EXPECT_TRUE(json["scene_times"].at(0)["seconds"]["sd"].is_null());
  EXPECT_TRUE(json["background"]["correlations"].at(0)["pearson"].is_null());
}

TEST(AnalysisJson, NamesThatAreNotUtf8DoNotBreakIt) {
  study::StudyRecords records = complete_study(1);
  records.protocol_name = "damaged \xff name";
  EXPECT_NO_THROW((void)json_of(records));
}

}  // namespace
}  // namespace foveola::analysis
