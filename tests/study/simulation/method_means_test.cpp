#include "study/simulation/method_means.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

TrialRow trial(const std::string& participant, const std::string& scene, const std::string& method,
               double outline_s) {
  return {.participant = participant,
          .scene = scene,
          .method = method,
          .outline_s = outline_s,
          .material_s = 3.0 * outline_s};
}

StudyRecords small_study() {
  StudyRecords records;
  records.methods = {"od", "fv"};
  records.trials = {trial("P1", "hall", "od", 2.0), trial("P1", "hall", "fv", 1.0),
                    trial("P2", "hall", "fv", 1.0), trial("P2", "hall", "od", 8.0)};
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
  records.trials[3].outline_censored = true;
  const std::vector<MethodMean> means = method_means(records);
  EXPECT_EQ(means[0].pairs, 1);
  EXPECT_NEAR(means[0].percent, 50.0, 1e-12);
  EXPECT_EQ(means[1].pairs, 2) << "the material was marked";
}

TEST(MethodMeans, WithoutPairsThereIsNone) {
  StudyRecords records = small_study();
  records.trials.resize(1);
  EXPECT_EQ(method_means(records)[0].pairs, 0);
  EXPECT_EQ(method_means(records)[0].percent, 0.0);
}

}  // namespace
}  // namespace foveola::study
