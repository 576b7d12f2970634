#include <gtest/gtest.h>

#include "study/protocol/reading/read_procedure.h"
#include "study/simulation/prediction_agreement.h"

namespace foveola::study {
namespace {

Value seconds(double number) { return {.state = Value::State::measured, .number = number}; }

StudyRecords small_study() {
  StudyRecords records;
  records.scenes = {"hall"};
  records.methods = {"od", "fv"};
  records.measures = trial_measures(published_marks(), {});
  for (const char* participant : {"P1", "P2"}) {
    records.sessions.push_back({participant, "simulated", "completed", {}, {}});
  }
  const auto add = [&](std::uint32_t session, std::uint16_t method, double outline_s) {
    records.add_trial({.session = session, .method = method, .attempt = 1},
                      {seconds(outline_s), seconds(3.0 * outline_s)});
  };
  add(0, 0, 2.0);
  add(0, 1, 1.0);
  add(1, 1, 1.0);
  add(1, 0, 8.0);
  return records;
}

// By hand: the ratios are 1/2 and 1/8, the root of their product 1/4; the baseline's are 2 and 8.
TEST(MethodMeans, AreGeometricMeansOfPairs) {
  const std::vector<MethodMean> means = method_means(small_study());
  ASSERT_EQ(means.size(), 2U);
  EXPECT_EQ(means[0].mark, "outline");
  EXPECT_EQ(means[0].method, "fv");
  EXPECT_EQ(means[0].pairs, 2);
  EXPECT_NEAR(means[0].baseline_s, 4.0, 1e-12);
  EXPECT_NEAR(means[0].percent, 25.0, 1e-12);
  EXPECT_EQ(means[1].mark, "material");
  EXPECT_NEAR(means[1].baseline_s, 12.0, 1e-12);
}

TEST(MethodMeans, ATimeOutLeavesOutThePair) {
  StudyRecords records = small_study();
  records.values[3 * 2].state = Value::State::right_censored;
  const std::vector<MethodMean> means = method_means(records);
  EXPECT_EQ(means[0].pairs, 1);
  EXPECT_NEAR(means[0].percent, 50.0, 1e-12);
  EXPECT_EQ(means[1].pairs, 2) << "the material was marked";
  records.values[2].state = Value::State::right_censored;
  EXPECT_EQ(method_means(records)[0].pairs, 0);
  EXPECT_EQ(method_means(records)[0].percent, 0.0);
}

TEST(MethodMeans, OnlyTimingsThatCountAreTaken) {
  StudyRecords records = small_study();
  TrialRow row = records.trials[1];
  row.counts = false;
  records.add_trial(row, {seconds(100.0), seconds(100.0)});
  row.counts = true;
  row.kind = TrialKind::practice;
  records.add_trial(row, {seconds(100.0), seconds(100.0)});
  EXPECT_NEAR(method_means(records)[0].percent, 25.0, 1e-12);
}

}  // namespace
}  // namespace foveola::study
