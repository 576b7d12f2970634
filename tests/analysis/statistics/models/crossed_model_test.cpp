#include "analysis/statistics/models/crossed_model.h"

#include <cmath>

#include "analysis/statistics/paired_t.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// lme4's numbers are those of its own iterations, polished to some ten digits.
void expect_lme4(double value, double golden) {
  EXPECT_NEAR(value, golden, 1e-8 * std::abs(golden));
}

constexpr const char* times_sample = "times_12x5";

TEST(CrossedModel, EstimatesAreThoseOfLme4InsideAndAtTheBoundary) {
  const auto golden = golden_models();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices("models_samples.csv")) {
    if (name == times_sample) {
      continue;
    }
    SCOPED_TRACE(name);
    const CrossedModel model = crossed_model(complete_participants(matrix)).value();
    EXPECT_EQ(model.participants, matrix.size());
    EXPECT_EQ(model.scenes, matrix.front().size());
    expect_lme4(model.mean, golden.at(name + ".mean"));
    expect_lme4(model.participant_variance, golden.at(name + ".participant_variance"));
    expect_lme4(model.scene_variance, golden.at(name + ".scene_variance"));
    expect_lme4(model.residual_variance, golden.at(name + ".residual_variance"));
    expect_lme4(model.test->standard_error, golden.at(name + ".standard_error"));
    expect_lme4(model.test->t, golden.at(name + ".t"));
    // lmerTest differentiates numerically.
    const double df = golden.at(name + ".lmertest_df");
    EXPECT_NEAR(model.test->degrees_of_freedom, df, 1e-5 * df);
    const double p = golden.at(name + ".lmertest_p");
    EXPECT_NEAR(model.test->p, p, 3e-5 * p);
    ++compared;
  }
  EXPECT_EQ(compared, 17);
}

TEST(CrossedModel, IsTheModelOfTheTimesThemselves) {
  const auto golden = golden_models();
  const GoldenMatrix times = golden_matrices("models_samples.csv").at(times_sample);
  RepeatedMeasures logs{times.size(), 5, {}};
  for (const auto& row : times) {
    for (std::size_t scene = 0; scene < 5; ++scene) {
      logs.values.push_back(std::log(*row[scene + 5]) - std::log(*row[scene]));
    }
  }
  const CrossedModel model = crossed_model(logs).value();
  const auto golden_of = [&](const char* quantity) {
    return golden.at(std::string(times_sample) + "." + quantity);
  };
  expect_lme4(model.mean, golden_of("mean"));
  expect_lme4(model.test->standard_error, golden_of("standard_error"));
  expect_lme4(model.participant_variance, golden_of("participant_variance"));
  expect_lme4(model.scene_variance, golden_of("scene_variance"));
  expect_lme4(model.residual_variance, golden_of("residual_variance"));
}

RepeatedMeasures golden_differences(const char* name) {
  return complete_participants(golden_matrices("models_samples.csv").at(name));
}

TEST(CrossedModel, WithoutDifferencesBetweenScenesItIsTheTOverParticipants) {
  const RepeatedMeasures data = golden_differences("no_scenes_12x5");
  std::vector<double> means;
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    means.push_back(*mean(data.of(participant)));
  }
  const RatioTest over_participants = test_ratio(means).value();
  const CrossedModel model = crossed_model(data).value();
  EXPECT_EQ(model.scene_variance, 0.0);
  EXPECT_GOLDEN(model.mean, over_participants.logs.mean);
  EXPECT_GOLDEN(model.test->t, over_participants.logs.t);
  EXPECT_GOLDEN(model.test->p, over_participants.logs.p);
  EXPECT_GOLDEN(model.test->interval.low, over_participants.logs.interval.low);
  EXPECT_GOLDEN(model.test->interval.high, over_participants.logs.interval.high);
}

TEST(CrossedModel, WithNeitherItIsTheTOverAllDifferences) {
  const RepeatedMeasures data = golden_differences("neither_16x5");
  const TTest over_all = test_mean(data.values).value();
  const CrossedTest test = crossed_model(data)->test.value();
  EXPECT_DOUBLE_EQ(test.degrees_of_freedom, 79.0);
  EXPECT_GOLDEN(test.t, over_all.t);
  EXPECT_GOLDEN(test.interval.low, over_all.interval.low);
}

TEST(CrossedModel, DifferencesThatDoNotVaryHaveAnEstimateAndNoTest) {
  // log(50) - log(100) and log(5) - log(10) are not the same double.
  const double half = std::log(50.0) - std::log(100.0);
  const double also_half = std::log(5.0) - std::log(10.0);
  ASSERT_NE(half, also_half);
  const CrossedModel model =
      crossed_model({2, 3, {half, also_half, half, also_half, half, half}}).value();
  EXPECT_NEAR(std::exp(model.mean), 0.5, 1e-15);
  EXPECT_FALSE(model.test);
}

TEST(CrossedModel, OneParticipantOrOneSceneIsNotEnough) {
  EXPECT_FALSE(crossed_model({1, 3, {0.1, 0.2, 0.3}}));
  EXPECT_FALSE(crossed_model({3, 1, {0.1, 0.2, 0.3}}));
  EXPECT_FALSE(crossed_model({}));
}

}  // namespace
}  // namespace foveola::analysis
