#include "analysis/monte_carlo/study_power.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/statistics/power.h"

namespace foveola::analysis {
namespace {

/// The example with a plan, and with these ratios of fv to od.
ExpectedStudy planned(const std::vector<study::PlannedComparison>& comparisons, double ratio,
                      study::SceneEffects scenes) {
  ExpectedStudy expected = example_study();
  expected.protocol.analysis.primary = comparisons;
  expected.protocol.analysis.scenes = scenes;
  for (ExpectedTimes& times : expected.times) {
    times.ratios = {1.0, 1.0, ratio};
  }
  return expected;
}

double power_of(const ExpectedStudy& expected, std::size_t participants, std::size_t studies = 2000,
                std::size_t comparison = 0) {
  const auto power = simulate_study_power(expected, participants, {.studies = studies});
  return static_cast<double>(hits_of(*power, comparison)) / static_cast<double>(studies);
}

TEST(StudyPower, OfFixedScenesIsThatOfThePairedT) {
  const ExpectedStudy expected =
      planned({{"outline", "fv", "od"}}, 0.75, study::SceneEffects::fixed);
  const ExpectedSpread& spread = expected.times_spread;
  const double sd = std::sqrt(spread.participants_gain * spread.participants_gain +
                              2.0 * spread.trials * spread.trials / 5.0);
  for (const std::size_t participants : {8U, 16U}) {
    const double formula = paired_t_power(participants, {std::log(0.75), sd});
    const double error = std::sqrt(formula * (1.0 - formula) / 2000.0);
    EXPECT_NEAR(power_of(expected, participants), formula, 4.0 * error);
  }
}

TEST(StudyPower, WithoutAnEffectIsTheErrorOfTheFirstKind) {
  ExpectedStudy expected = planned({{"outline", "fv", "od"}}, 1.0, study::SceneEffects::random);
  expected.times_spread.scenes_gain = 0.2;
  const double rejected = power_of(expected, 16);
  EXPECT_GT(rejected, 0.03);
  EXPECT_LT(rejected, 0.07);
}

TEST(StudyPower, OfAFamilyIsLessThanThatOfOneComparison) {
  const ExpectedStudy one = planned({{"outline", "fv", "od"}}, 0.8, study::SceneEffects::fixed);
  // Of the second there is nothing to be found.
  const ExpectedStudy two =
      planned({{"outline", "fv", "od"}, {"outline", "vp", "od"}}, 0.8, study::SceneEffects::fixed);
  const ExpectedSpread& spread = one.times_spread;
  const double sd = std::sqrt(spread.participants_gain * spread.participants_gain +
                              2.0 * spread.trials * spread.trials / 5.0);
  const double at_half = paired_t_power(16, {std::log(0.8), sd}, 0.025);
  EXPECT_NEAR(power_of(two, 16), at_half, 0.05);
  EXPECT_LT(power_of(two, 16), power_of(one, 16));
  const auto power = simulate_study_power(two, 16, {.studies = 500});
  EXPECT_LE(power->all_significant, power->comparisons[1].significant);
}

TEST(StudyPower, WithdrawalsCostParticipants) {
  ExpectedStudy expected = planned({{"outline", "fv", "od"}}, 0.75, study::SceneEffects::fixed);
  expected.withdrawals = 0.5;
  const auto power = simulate_study_power(expected, 16, {.studies = 2000});
  EXPECT_NEAR(power->analysed, 8.0, 0.2);
  expected.withdrawals = 0.0;
  EXPECT_LT(power->comparisons[0].significant, 2000.0 * power_of(expected, 11));
  EXPECT_GT(power->comparisons[0].significant, 2000.0 * power_of(expected, 5));
}

TEST(StudyPower, AStudyThatEverybodyLeavesFindsNothing) {
  ExpectedStudy expected = planned({{"outline", "fv", "od"}}, 0.5, study::SceneEffects::fixed);
  expected.withdrawals = 1.0;
  const auto power = simulate_study_power(expected, 6, {.studies = 30});
  EXPECT_EQ(power->studies, 30U);
  EXPECT_EQ(power->comparisons[0].significant, 0U);
  EXPECT_EQ(power->all_significant, 0U);
}

TEST(StudyPower, CountsCensoredTimesAndTheAnalysesThatStandIn) {
  ExpectedStudy expected = planned({{"material", "fv", "od"}}, 0.5, study::SceneEffects::random);
  const auto complete = simulate_study_power(expected, 8, {.studies = 50});
  EXPECT_EQ(complete->censored[1][0], 0.0);
  EXPECT_EQ(complete->comparisons[0].stand_ins, 0U);
  EXPECT_EQ(complete->comparisons[0].analyses.at(AnalysisKind::crossed_model), 50U);
  expected.protocol.timing.mark_timeout_s = 60.0;
  const auto censored = simulate_study_power(expected, 8, {.studies = 50});
  EXPECT_GT(censored->censored[1][0], censored->censored[1][2]);
  EXPECT_GT(censored->comparisons[0].stand_ins, 40U);
}

TEST(StudyPower, TakesTheModelsThatAreFitted) {
  ExpectedStudy expected = planned({{"material", "fv", "od"}}, 0.5, study::SceneEffects::random);
  expected.protocol.timing.mark_timeout_s = 60.0;
  PowerSimulation simulation{.studies = 30};
  simulation.fit_models = [](const std::vector<study::StudyRecords>& studies) {
    FittedModel model{.model = "tobit", .measure = "material", .method = "fv", .reference = "od"};
    model.fit = FittedModel::Fit{.estimate = -1.0, .p = 0.001};
    return std::vector<FittedModels>(studies.size(), FittedModels{.models = {model}});
  };
  const auto power = simulate_study_power(expected, 8, simulation);
  EXPECT_GT(power->comparisons[0].analyses.at(AnalysisKind::tobit_model), 25U);
}

TEST(StudyPower, DoesNotDependOnThreads) {
  const ExpectedStudy expected =
      planned({{"outline", "fv", "od"}}, 0.8, study::SceneEffects::random);
  const auto alone = simulate_study_power(expected, 10, {.studies = 110, .threads = 1});
  const auto together = simulate_study_power(expected, 10, {.studies = 110, .threads = 4});
  EXPECT_EQ(alone->studies, 110U);
  EXPECT_EQ(alone->comparisons[0].significant, together->comparisons[0].significant);
}

TEST(StudyPower, ACurveHasTheFewestParticipants) {
  const ExpectedStudy expected = planned({{"outline", "fv", "od"}, {"material", "fv", "od"}}, 0.75,
                                         study::SceneEffects::fixed);
  std::vector<std::size_t> tried;
  const std::vector<StudyPower> curve =
      power_curve(expected, {.power = 0.8, .planned = 50}, {.studies = 300},
                  [&](std::size_t participants) { tried.push_back(participants); });
  EXPECT_EQ(curve.size(), tried.size());
  for (const std::optional<std::size_t> criterion :
       {std::optional<std::size_t>(), std::optional<std::size_t>(0U),
        std::optional<std::size_t>(1U)}) {
    const auto fewest = fewest_participants(curve, criterion, 0.8);
    ASSERT_TRUE(fewest);
    const auto hits = [&](std::size_t participants) {
      return hits_of(*simulate_study_power(expected, participants, {.studies = 300}), criterion);
    };
    EXPECT_GE(hits(*fewest), 240U);
    EXPECT_LT(hits(*fewest - 1), 240U);
  }
  EXPECT_EQ(curve.back().participants, 50U);
}

TEST(StudyPower, TheFewestParticipantsReachTheTargetAndSoDoAllMore) {
  std::vector<StudyPower> curve;
  for (const std::size_t hits : {7U, 8U, 7U, 8U, 9U}) {
    curve.push_back(
        {.participants = 4 * (curve.size() + 1), .studies = 10, .all_significant = hits});
  }
  EXPECT_EQ(fewest_participants(curve, std::nullopt, 0.8), 16U);
}

TEST(StudyPower, ATargetOutOfReachHasNoFewestParticipants) {
  ExpectedStudy expected = planned({{"outline", "fv", "od"}}, 0.9, study::SceneEffects::random);
  expected.times_spread.scenes_gain = 0.5;
  const std::vector<StudyPower> curve =
      power_curve(expected, {.power = 0.9, .most = 24}, {.studies = 50}, [](std::size_t) {});
  EXPECT_EQ(curve.back().participants, 24U);
  EXPECT_FALSE(fewest_participants(curve, 0, 0.9));
}

TEST(StudyPower, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(power_curve(example_study(), {}, {}, [](std::size_t) {}, stop.get_token()).empty());
}

}  // namespace
}  // namespace foveola::analysis
