#include "analysis/commands/statistics_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

BenchPart part_with(nlohmann::json results) {
  return {.command = statistics_command,
          .shard = {},
          .settings = settings_json(CoverageSettings{.studies = 7, .seed = 1ULL << 63U}),
          .results = std::move(results),
          .file = "part.json"};
}

StudyCounts two_counts() {
  StudyCounts counts(2);
  for (const double estimate : {1e16, 1.0, -1e16}) {
    counts[0].add(true);
    counts[0].estimates.add(estimate / 1e6);
  }
  counts[1].add(false);
  return counts;
}

TEST(StatisticsPart, HoldsItsSettings) {
  const BenchPart part = part_with({});
  const CoverageSettings settings = coverage_settings_of(part);
  EXPECT_FALSE(is_of_models(part));
  EXPECT_EQ(settings.studies, 7);
  EXPECT_EQ(settings.participants, CoverageSettings{}.participants);
  EXPECT_EQ(settings.resamples, CoverageSettings{}.resamples);
  EXPECT_EQ(settings.seed, 1ULL << 63U);
  BenchPart of_models = part;
  of_models.settings = settings_json(
      ModelBench{.settings = {.studies = 9, .seed = 4}, .only = "Tobit", .fitted_by = "R 4"});
  ASSERT_TRUE(is_of_models(of_models));
  const ModelBench bench = model_bench_of(of_models);
  EXPECT_EQ(bench.settings.studies, 9U);
  EXPECT_EQ(bench.settings.seed, 4U);
  EXPECT_EQ(bench.only, "Tobit");
}

TEST(StatisticsPart, CountsAddUpExactly) {
  const BenchPart part = part_with(counts_json(two_counts()));
  const StudyCounts sums = merged_counts({part, part}, 2);
  EXPECT_EQ(sums[0].studies, 6U);
  EXPECT_EQ(sums[0].hits, 6U);
  EXPECT_EQ(sums[1].studies, 2U);
  EXPECT_EQ(sums[1].hits, 0U);
  ExactSum twice;
  twice.add(two_counts()[0].estimates);
  twice.add(two_counts()[0].estimates);
  EXPECT_EQ(sums[0].estimates.rounded(), twice.rounded());
}

TEST(StatisticsPart, RefusesCountsThatAreNone) {
  const nlohmann::json good = counts_json(two_counts());
  const auto refuses = [](const nlohmann::json& results) {
    EXPECT_THROW((void)merged_counts({part_with(results)}, 2), Error) << results;
  };
  EXPECT_NO_THROW((void)merged_counts({part_with(good)}, 2));
  EXPECT_THROW((void)merged_counts({part_with(good)}, 3), Error);
  refuses(nullptr);
  refuses({1, 2});
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, nlohmann::json>>{{"hits", 4},
                                                           {"studies", -1},
                                                           {"studies", 1e300},
                                                           {"estimates", "all"},
                                                           {"estimates", {"a"}},
                                                           {"estimates", {1e300, 1e300}},
                                                           {"estimates", std::vector(100, 1.0)}}) {
    nlohmann::json bad = good;
    bad[0][name] = value;
    refuses(bad);
  }
}

}  // namespace
}  // namespace foveola::analysis
