#include "analysis/dataset/study_tables.h"

#include <map>

#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;

std::string key(const std::string& mark, const std::string& method, const std::string& quantity) {
  return mark + "." + method + "." + quantity;
}

void expect_golden(const std::optional<Estimate>& estimate,
                   const std::map<std::string, double>& golden, const std::string& value_key,
                   const std::string& low_key, const std::string& high_key) {
  ASSERT_TRUE(estimate && estimate->interval) << value_key;
  EXPECT_GOLDEN(estimate->value, golden.at(value_key)) << value_key;
  EXPECT_GOLDEN(estimate->interval->low, golden.at(low_key)) << low_key;
  EXPECT_GOLDEN(estimate->interval->high, golden.at(high_key)) << high_key;
}

TEST(StudyTables, Table2IsThatOfR) {
  const auto golden = golden_study();
  const StudyTables tables = tabulate_study(golden_study_records());
  ASSERT_EQ(tables.scene_times.size(), 2U * 3U * 3U);
  for (const SceneTimes& times : tables.scene_times) {
    const std::string cell = times.mark + "." + times.scene + "." + times.method + ".";
    SCOPED_TRACE(cell);
    EXPECT_EQ(static_cast<double>(times.seconds.n), golden.at(cell + "n"));
    EXPECT_GOLDEN(times.seconds.mean.value(), golden.at(cell + "mean_s"));
    EXPECT_GOLDEN(times.seconds.standard_deviation.value(), golden.at(cell + "sd_s"));
    if (times.method == "od") {
      EXPECT_EQ(times.percent_of_baseline.n, 0U);
      continue;
    }
    EXPECT_EQ(static_cast<double>(times.percent_of_baseline.n), golden.at(cell + "n_pairs"));
    EXPECT_GOLDEN(times.percent_of_baseline.mean.value(), golden.at(cell + "mean_percent"));
    EXPECT_GOLDEN(times.percent_of_baseline.standard_deviation.value(),
                  golden.at(cell + "sd_percent"));
    expect_golden(times.geometric_percent, golden, cell + "geometric_percent",
                  cell + "geometric_percent_low", cell + "geometric_percent_high");
    EXPECT_GOLDEN(times.of_baseline_mean.mean_percent.value(),
                  golden.at(cell + "ratio_of_means_percent"));
    EXPECT_GOLDEN(times.of_baseline_mean.sd_percent_points.value(),
                  golden.at(cell + "sd_percent_points"));
  }
}

TEST(StudyTables, Figure5IsThatOfR) {
  const auto golden = golden_study();
  for (const MethodTimes& times : tabulate_study(golden_study_records()).method_times) {
    expect_golden(times.seconds, golden, key(times.mark, times.method, "geometric_mean_s"),
                  key(times.mark, times.method, "low_s"), key(times.mark, times.method, "high_s"));
    if (times.method != "od") {
      expect_golden(times.percent_of_baseline, golden,
                    key(times.mark, times.method, "geometric_mean_percent"),
                    key(times.mark, times.method, "low_percent"),
                    key(times.mark, times.method, "high_percent"));
    }
  }
}

TEST(StudyTables, Figure6IsThatOfR) {
  const auto golden = golden_study();
  const StudyTables tables = tabulate_study(golden_study_records());
  ASSERT_EQ(tables.ratings.size(), 3U);
  for (const MethodRatings& ratings : tables.ratings) {
    const std::string method = "rating." + ratings.method + ".";
    SCOPED_TRACE(method);
    EXPECT_EQ(static_cast<double>(ratings.description.n), golden.at(method + "n"));
    EXPECT_GOLDEN(ratings.description.mean.value(), golden.at(method + "mean"));
    EXPECT_GOLDEN(ratings.description.standard_deviation.value(), golden.at(method + "sd"));
    EXPECT_GOLDEN(ratings.description.median.value(), golden.at(method + "median"));
    for (int answer = 1; answer <= 5; ++answer) {
      const RatingCount& counted = ratings.counts.at(static_cast<std::size_t>(answer - 1));
      EXPECT_EQ(counted.value, answer);
      EXPECT_EQ(static_cast<double>(counted.count),
                golden.at(method + "count_" + std::to_string(answer)));
    }
  }
  EXPECT_EQ(tables.ratings[0].missing, 1U);
  EXPECT_EQ(tables.ratings[1].missing, 1U);
  EXPECT_EQ(tables.ratings[2].missing, 0U);
}

TEST(StudyTables, CensoredAndMissingTimesAreCounted) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const SceneTimes& timed_out = tables.scene_times_of(outline_index, 0, 0);
  EXPECT_EQ(timed_out.censored, 1);
  EXPECT_EQ(timed_out.missing, 0);
  EXPECT_EQ(timed_out.seconds.n, 7U);
  const SceneTimes& not_shown = tables.scene_times_of(outline_index, 0, 1);
  EXPECT_EQ(not_shown.censored, 0);
  EXPECT_EQ(not_shown.missing, 1);
  EXPECT_EQ(not_shown.seconds.n, 7U);
  EXPECT_EQ(not_shown.percent_of_baseline.n, 6U);
  EXPECT_EQ(tables.incomplete_scenes, 5U);
}

TEST(StudyTables, ACensoredTimeIsInNoMean) {
  StudyRecords records = complete_study(3);
  value_of(records, "P2", "aula", "od", "outline") = right_censored(1e6);
  const StudyTables tables = tabulate_study(records);
  EXPECT_LT(tables.scene_times_of(outline_index, 0, 0).seconds.mean.value(), 100.0);
  for (const MethodTimes& times : tables.method_times) {
    EXPECT_LT(times.seconds->value, 100.0);
  }
}

TEST(StudyTables, RelativeTimesAreQuotientsOfTheSeconds) {
  const StudyTables tables = tabulate_study(golden_study_records());
  for (const std::size_t mark : tables.set.times()) {
    for (std::size_t method = 1; method < 3; ++method) {
      const MethodTimes& times = tables.method_times_of(mark, method);
      const double od = tables.method_times_of(mark, baseline).seconds->value;
      EXPECT_NEAR(times.percent_of_baseline->value, 100.0 * times.seconds->value / od, 1e-10);
    }
  }
}

TEST(StudyTables, OneParticipantHasValuesWithoutSpread) {
  const StudyTables tables = tabulate_study(complete_study(1));
  for (const SceneTimes& times : tables.scene_times) {
    EXPECT_TRUE(times.seconds.mean);
    EXPECT_FALSE(times.seconds.standard_deviation);
  }
  for (const MethodTimes& times : tables.method_times) {
    EXPECT_TRUE(times.seconds);
    EXPECT_FALSE(times.seconds->interval);
  }
}

TEST(StudyTables, OneMethodHasNothingToCompare) {
  const StudyTables tables = tabulate_study(with_od_alone(complete_study(2)));
  EXPECT_EQ(tables.method_times.size(), 2U);
  EXPECT_THAT(tables.set.exclusions, IsEmpty());
}

TEST(StudyTables, AnyMethodMayBeTheBaseline) {
  StudyRecords records = complete_study(4);
  records.methods = {"fv", "od"};
  keep_trials(records, [](const study::TrialRow& row) { return row.method != 1; });
  for (study::TrialRow& row : records.trials) {
    row.method = row.method == 2 ? 0 : 1;
  }
  const StudyTables tables = tabulate_study(records);
  EXPECT_FALSE(tables.method_times_of(outline_index, 0).percent_of_baseline);
  EXPECT_GT(tables.method_times_of(outline_index, 1).percent_of_baseline->value, 100.0);
}

TEST(StudyTables, AMarkThatNobodyMadeLeavesItsCellsEmpty) {
  StudyRecords records = complete_study(3);
  change_values(records, "material", [](study::Value& value) { value = {}; });
  const StudyTables tables = tabulate_study(records);
  EXPECT_FALSE(tables.scene_times_of(material_index, 0, 0).seconds.mean);
  EXPECT_FALSE(tables.method_times_of(material_index, 2).seconds);
  EXPECT_TRUE(tables.method_times_of(outline_index, 2).seconds);
}

}  // namespace
}  // namespace foveola::analysis
