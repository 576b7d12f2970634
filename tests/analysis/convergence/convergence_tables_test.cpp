#include "analysis/convergence/convergence_tables.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/analysis/convergence/made_up_measurement.h"

namespace foveola::analysis {
namespace {

const SpeedUp& find(const ConvergenceTables& tables, const std::string& configuration,
                    Metric metric, Level level) {
  const auto found =
      std::find_if(tables.speed_ups.begin(), tables.speed_ups.end(), [&](const SpeedUp& row) {
        return row.configuration == configuration && row.metric == metric && row.level == level;
      });
  EXPECT_NE(found, tables.speed_ups.end());
  return *found;
}

double value(const std::optional<Estimate>& estimate) { return estimate ? estimate->value : 0.0; }

// A tenth of the noise at thrice the price: ten times fewer samples, 10 / 3 of the time.
TEST(Tabulate, FindsTheSpeedUpThatIsThere) {
  const ConvergenceTables tables = tabulate(
      {made_up_measurement({{.name = "od", .noise = 5.0, .cost_s = 1e-3},
                            {.name = "fv", .noise = 0.5, .cost_s = 3e-3, .per_pixel = 1e-2}},
                           3, 0.2)});
  for (const Metric metric : metrics) {
    for (const Level level : levels) {
      const SpeedUp& row = find(tables, "fv", metric, level);
      EXPECT_NEAR(value(row.samples_ratio), 10.0, 1e-9);
      EXPECT_NEAR(value(row.time_ratio), 10.0 / 3.0, 1e-9);
      // All repetitions agree on it.
      ASSERT_TRUE(row.samples_ratio->interval);
      EXPECT_NEAR(row.samples_ratio->interval->low, 10.0, 1e-6);
      EXPECT_NEAR(row.samples_ratio->interval->high, 10.0, 1e-6);
      EXPECT_EQ(row.predicted.has_value(), metric == Metric::mse);
    }
  }
  EXPECT_NEAR(find(tables, "fv", Metric::mse, Level::all).predicted.value_or(0.0), 10.0, 1e-12);
}

// What needs more than the baseline is compared at the error that it reached itself.
TEST(Tabulate, FindsASlowDownToo) {
  const ConvergenceTables tables = tabulate({made_up_measurement(
      {{.name = "od", .noise = 1.0}, {.name = "od, worse", .noise = 2.5}}, 2)});
  EXPECT_NEAR(value(find(tables, "od, worse", Metric::mse, Level::all).samples_ratio), 0.4, 1e-9);
  EXPECT_NEAR(value(find(tables, "od, worse", Metric::mse, Level::quarter).time_ratio), 0.4, 1e-9);
}

TEST(Tabulate, ExtrapolatesNoSpeedUpBeyondTheCurves) {
  const ConvergenceTables tables = tabulate(
      {made_up_measurement({{.name = "od", .noise = 1.0}, {.name = "magic", .noise = 1e-4}}, 2)});
  EXPECT_FALSE(find(tables, "magic", Metric::mse, Level::all).samples_ratio);
}

TEST(Tabulate, HasCostsSlopesAndEfficiencies) {
  const ConvergenceTables tables =
      tabulate({made_up_measurement({{.name = "od", .noise = 5.0, .cost_s = 1e-6},
                                     {.name = "fv", .noise = 0.5, .cost_s = 3e-6, .decay = 1.5}},
                                    2)});
  ASSERT_EQ(tables.costs.size(), 2U);
  EXPECT_NEAR(value(tables.costs[0].ns_per_path), 1000.0, 1e-9);
  EXPECT_NEAR(value(tables.costs[1].ratio), 3.0, 1e-12);
  ASSERT_EQ(tables.convergence.size(), 2U);
  EXPECT_NEAR(value(tables.convergence[0].slope_in_samples), -0.5, 1e-12);
  EXPECT_NEAR(value(tables.convergence[1].slope_in_samples), -0.75, 1e-12);
  EXPECT_NEAR(value(tables.convergence[1].slope_in_time), -0.75, 1e-12);
  // 64000 samples: 1 / (5 / 64000 * 0.064).
  EXPECT_NEAR(value(tables.convergence[0].efficiency), 200'000.0, 1e-6);
  EXPECT_NEAR(value(tables.convergence[1].efficiency_ratio), 10.0 * std::sqrt(64000.0) / 3.0, 1e-6);
}

TEST(Tabulate, TakesTheGeometricMeanOverScenes) {
  GazeMeasurement one = made_up_measurement({{.name = "od"}, {.name = "fv", .noise = 0.1}}, 2);
  GazeMeasurement other = made_up_measurement({{.name = "od"}, {.name = "fv", .noise = 0.4}}, 2);
  other.scene = "bakery";
  const ConvergenceTables tables = tabulate({one, other});
  ASSERT_EQ(tables.overall.size(), metrics.size() * levels.size());
  EXPECT_NEAR(value(tables.overall.front().samples_ratio), 5.0, 1e-9);
  EXPECT_NEAR(tables.overall.front().predicted.value_or(0.0), 5.0, 1e-9);
  EXPECT_EQ(tables.overall.front().samples_ratio->n, 2U);
  // A scene without a value must not make the others look like all.
  for (RenderLog& log : other.repetitions[0]) {
    for (Checkpoint& checkpoint : log.checkpoints) {
      checkpoint.scores[0].error.empty_share = 1.0;
    }
  }
  EXPECT_FALSE(tabulate({one, other}).overall.front().samples_ratio);
}

}  // namespace
}  // namespace foveola::analysis
