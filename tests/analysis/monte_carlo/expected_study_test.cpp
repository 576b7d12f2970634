#include "analysis/monte_carlo/expected_study.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/statistics/correlation.h"
#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/models/crossed_model.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t outline = 0;
constexpr std::size_t material = 1;
constexpr std::size_t artifacts = 3;
constexpr std::size_t comfort = 4;

std::vector<double> differences(const Dataset& set, std::size_t measure, std::size_t method) {
  return paired_differences(participant_means(set, measure), method, baseline);
}

TEST(ExpectedStudy, IsSimulatedAndComplete) {
  const study::StudyRecords records = draw_study(example_study(), 5, 4);
  EXPECT_EQ(records.trials.size(), 5U * 5U * 3U);
  EXPECT_TRUE(records.has_simulated());
  EXPECT_TRUE(tabulate_study(records).set.exclusions.empty());
}

TEST(ExpectedStudy, HoldsTheExpectedRatiosOfEveryMark) {
  ExpectedStudy expected = example_study();
  expected.times[material].ratios = {1.0, 0.5, 0.2};
  const Dataset set = select_for_analysis(draw_study(expected, 400, 11));
  for (const std::size_t mark : {outline, material}) {
    for (const std::size_t method : {1U, 2U}) {
      const std::vector<double> logs = differences(set, mark, method);
      const double error = *describe(logs).standard_deviation / std::sqrt(400.0);
      EXPECT_NEAR(*mean(logs), std::log(expected.times[mark].ratios[method]), 4.0 * error);
      EXPECT_LT(error, 0.025);
    }
  }
}

TEST(ExpectedStudy, MarksOfATrialDependOnEachOtherAsIsStated) {
  ExpectedStudy expected = example_study();
  expected.times_spread = {.participants = 0.0,
                           .scenes = 0.0,
                           .participants_gain = 0.0,
                           .scenes_gain = 0.0,
                           .trials = 0.3};
  for (const double variation : {0.0, 0.25, 1.0}) {
    expected.later_marks_variation = variation;
    const Dataset set = select_for_analysis(draw_study(expected, 800, 5));
    std::vector<double> before;
    std::vector<double> after;
    for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
      for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
        before.push_back(std::log(set.value(participant, scene, baseline, outline).number));
        after.push_back(std::log(set.value(participant, scene, baseline, material).number));
      }
    }
    EXPECT_NEAR(pearson(before, after)->r, correlation_with_mark_before(expected, material, 0),
                0.04);
  }
}

TEST(ExpectedStudy, HoldsTheExpectedSpreadsOfGains) {
  ExpectedStudy expected = example_study();
  for (int scene = 6; scene <= 200; ++scene) {
    expected.protocol.scenes.push_back({.name = "scene-" + std::to_string(scene)});
  }
  expected.times_spread = {.participants = 0.6,
                           .scenes = 0.4,
                           .participants_gain = 0.3,
                           .scenes_gain = 0.2,
                           .trials = 0.35};
  const Dataset set = select_for_analysis(draw_study(expected, 200, 5));
  const PairedTrials trials = paired_trials(set, outline, 2, baseline);
  const auto model = crossed_model(complete_participants(trials.differences));
  ASSERT_TRUE(model);
  // With 200 of each, the relative error of a standard deviation is 5 %.
  EXPECT_NEAR(std::sqrt(model->participant_variance), 0.3, 0.06);
  EXPECT_NEAR(std::sqrt(model->scene_variance), 0.2, 0.04);
  EXPECT_NEAR(std::sqrt(model->residual_variance), 0.35 * std::sqrt(2.0), 0.02);
}

TEST(ExpectedStudy, MarksComeOneAfterTheOther) {
  const study::StudyRecords records = draw_study(example_study(), 50, 2);
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    EXPECT_LT(records.value(row, 0).number, records.value(row, 1).number);
    EXPECT_LT(records.value(row, 1).number, records.value(row, 2).number);
  }
}

TEST(ExpectedStudy, RatingsAreShiftedOnTheirScale) {
  ExpectedStudy expected = example_study();
  expected.shifts = {{0.0, 0.0, 1.0}, {0.0, 0.0, -20.0}};
  const Dataset set = select_for_analysis(draw_study(expected, 400, 3));
  EXPECT_NEAR(*mean(differences(set, artifacts, 2)), 1.0, 0.1);
  EXPECT_NEAR(*mean(differences(set, comfort, 2)), -20.0, 1.5);
  for (std::size_t trial = 0; trial < set.trials.size(); ++trial) {
    const double answer = set.values[trial * set.measures.size() + artifacts].number;
    EXPECT_GE(answer, 1.0);
    EXPECT_LE(answer, 5.0);
    EXPECT_EQ(answer, std::round(answer));
  }
}

TEST(ExpectedStudy, TheFirstParticipantsDoNotDependOnHowManyThereAre) {
  const study::StudyRecords few = draw_study(example_study(), 3, 9);
  const study::StudyRecords many = draw_study(example_study(), 30, 9);
  for (std::size_t i = 0; i < few.values.size(); ++i) {
    EXPECT_EQ(few.values[i].number, many.values[i].number);
  }
}

TEST(ExpectedStudy, WhoWithdrawsHasNoTrials) {
  ExpectedStudy expected = example_study();
  expected.withdrawals = 0.25;
  const study::StudyRecords records = draw_study(expected, 400, 6);
  std::vector<bool> withdrawn;
  for (const study::SessionRow& session : records.sessions) {
    withdrawn.push_back(session.state == "withdrawn");
  }
  const auto count = static_cast<double>(std::count(withdrawn.begin(), withdrawn.end(), true));
  EXPECT_NEAR(count, 100.0, 35.0);  // Four standard deviations.
  for (const study::TrialRow& row : records.trials) {
    EXPECT_FALSE(withdrawn[row.session]);
  }
}

TEST(ExpectedStudy, TimesBeyondTheirTrialsTimeoutAreCensored) {
  ExpectedStudy expected = example_study();
  expected.protocol.timing.mark_timeout_s = 30.0;
  study::TrialSettings shorter;
  shorter.timing.mark_timeout_s = 5.0;
  expected.protocol.cells[{"scene-1", "fv"}] = shorter;
  const study::StudyRecords records = draw_study(expected, 40, 8);
  std::size_t censored = 0;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    const study::TrialRow& trial = records.trials[row];
    const bool is_shorter = trial.scene == 0 && records.methods[trial.method] == "fv";
    const double timeout_s = is_shorter ? 5.0 : 30.0;
    for (std::size_t mark = 0; mark < 3; ++mark) {
      const Value& value = records.value(row, mark);
      if (value.state == Value::State::right_censored) {
        EXPECT_EQ(value.number, timeout_s);
        ++censored;
      } else {
        EXPECT_LE(value.number, timeout_s);
      }
    }
  }
  EXPECT_GT(censored, 100U);
}

}  // namespace
}  // namespace foveola::analysis
