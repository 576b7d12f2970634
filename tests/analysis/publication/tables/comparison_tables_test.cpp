#include <cmath>

#include <nlohmann/json.hpp>

#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

study::AnalysisPlan outline_planned() {
  study::AnalysisPlan plan;
  plan.primary = {{"outline", "fv", "od"}};
  plan.equivalence_margins = {{"artifacts", 1.0}, {"outline", 1.5}};
  return plan;
}

TEST(ComparisonTables, AreTheSameAsJson) {
  const auto golden = golden_study();
  const StudyTables tables = tabulate_study(golden_study_records());
  const nlohmann::ordered_json rows =
      json_of(comparisons_table(tables, compare_methods(tables.set, {})));
  const auto fv = rows.at(1);
  EXPECT_EQ(fv["measure"], "outline");
  EXPECT_EQ(fv["method"], "fv");
  EXPECT_EQ(fv["status"], "exploratory");
  EXPECT_GOLDEN(fv["complete_ratio_percent"].get<double>(),
                golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_EQ(fv["analysis"], "crossed mixed model");
  EXPECT_EQ(fv["scale"], "ratio");
  EXPECT_TRUE(fv["difference_points"].is_null());
  EXPECT_EQ(fv["wilcoxon_exact"], true);
}

TEST(ComparisonTables, APlannedOneWithoutPSaysWhy) {
  study::StudyRecords records = complete_study(4);
  change_values(records, "outline", [](study::Value& value) { value = {}; });
  const StudyTables tables = tabulate_study(records);
  const nlohmann::ordered_json rows =
      json_of(comparisons_table(tables, compare_methods(tables.set, outline_planned())));
  EXPECT_EQ(rows.at(0)["status"], "planned");
  EXPECT_TRUE(rows.at(0)["p_holm"].is_null());
  EXPECT_EQ(rows.at(0)["missing"], "no participant with both values: a test needs two");
}

TEST(ComparisonTables, EquivalenceIsInTheMarginsUnit) {
  const StudyTables tables = tabulate_study(complete_study(8));
  study::AnalysisPlan plan;
  plan.equivalence_margins = {{"outline", 1.5}, {"artifacts", 0.5}};
  const Comparisons comparisons = compare_methods(tables.set, plan);
  const nlohmann::ordered_json rows = json_of(comparisons_table(tables, comparisons));
  const MethodComparison& outline = comparisons.methods.front();
  const MethodComparison& artifacts = comparisons.methods.back();
  EXPECT_EQ(rows.front()["equivalence_margin"], 1.5);
  EXPECT_DOUBLE_EQ(rows.front()["equivalence_interval_low"].get<double>(),
                   std::exp(outline.equivalent->interval->low));
  EXPECT_EQ(rows.back()["equivalence_interval_high"], artifacts.equivalent->interval->high);
}

TEST(ComparisonTables, HaveOrderEffectsAndEffectSizes) {
  study::StudyRecords records = golden_study_records();
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    records.trials[i].method_position = static_cast<std::uint16_t>((i + i / 9) % 3);
  }
  const StudyTables tables = tabulate_study(records);
  const Comparisons expected = compare_methods(tables.set, {});
  const nlohmann::ordered_json order = json_of(order_effects_table(tables, expected));
  ASSERT_EQ(order.size(), 6U);
  EXPECT_EQ(order.at(1)["d_z"], expected.order.at(1).change_per_step->d_z);
  const nlohmann::ordered_json omnibus = json_of(omnibus_table(tables, expected));
  EXPECT_GT(omnibus.at(0)["f"].get<double>(), 1.0);
  EXPECT_EQ(omnibus.at(0)["partial_eta_squared"],
            expected.omnibus.at(0).variance->partial_eta_squared);
  EXPECT_EQ(omnibus.at(0)["p_huynh_feldt"], expected.omnibus.at(0).variance->p_huynh_feldt);
  EXPECT_DOUBLE_EQ(json_of(comparisons_table(tables, expected))
                       .at(1)["pseudo_median_ratio_percent"]
                       .get<double>(),
                   100.0 * std::exp(expected.methods.at(1).pseudo_median->value));
}

}  // namespace
}  // namespace foveola::analysis
