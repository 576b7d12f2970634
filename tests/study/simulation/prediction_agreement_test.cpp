#include "study/simulation/prediction_agreement.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

TrialRow trial(const std::string& scene, const std::string& method, double outline_s) {
  return {.participant = "P001",
          .scene = scene,
          .method = method,
          .outline_s = outline_s,
          .material_s = 2.0 * outline_s};
}

// By R's cor(method = "spearman").
TEST(PredictionAgreement, RanksAreCorrelatedAsByR) {
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {10.0, 30.0, 20.0, 40.0}), 0.8, 1e-12);
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 2.0, 4.0}, {4.0, 3.0, 2.0, 1.0}), -0.9486833, 1e-7);
  EXPECT_EQ(rank_correlation({1.0}, {2.0}), 0.0);
  EXPECT_EQ(rank_correlation({1.0, 1.0}, {2.0, 3.0}), 0.0);
}

TEST(PredictionAgreement, MediansAreInTheMiddle) {
  EXPECT_EQ(median_of({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median_of({4.0, 1.0, 2.0, 8.0}), 3.0);
  EXPECT_EQ(median_of({}), 0.0);
}

TEST(PredictionAgreement, PairsTrialsWhateverTheirOrder) {
  StudyRecords rendered;
  rendered.methods = {"od", "fv"};
  rendered.trials = {trial("hall", "od", 8.0), trial("box", "od", 4.0), trial("hall", "fv", 1.0)};
  StudyRecords predicted = rendered;
  predicted.trials = {trial("hall", "fv", 1.5), trial("hall", "od", 8.8), trial("box", "od", 4.0),
                      trial("box", "fv", 0.5)};
  const std::vector<MarkAgreement> agreements = prediction_agreement(rendered, predicted);
  ASSERT_EQ(agreements.size(), 6U);
  EXPECT_EQ(agreements[0].mark, "outline");
  EXPECT_EQ(agreements[0].method, "");
  EXPECT_EQ(agreements[0].trials, 3) << "one was not rendered";
  EXPECT_DOUBLE_EQ(agreements[0].median_ratio, 1.1);
  EXPECT_DOUBLE_EQ(agreements[0].rendered_median_s, 4.0);
  EXPECT_DOUBLE_EQ(agreements[0].rank_correlation, 1.0);
  EXPECT_EQ(agreements[1].method, "od");
  EXPECT_EQ(agreements[1].trials, 2);
  EXPECT_EQ(agreements[5].mark, "material");
  EXPECT_DOUBLE_EQ(agreements[5].median_ratio, 1.5);
}

TEST(PredictionAgreement, TimeoutsDoNotCount) {
  StudyRecords rendered;
  rendered.methods = {"od"};
  rendered.trials = {trial("hall", "od", 8.0), trial("box", "od", 4.0)};
  StudyRecords predicted = rendered;
  rendered.trials[0].outline_censored = true;
  predicted.trials[1].material_censored = true;
  const std::vector<MarkAgreement> agreements = prediction_agreement(rendered, predicted);
  EXPECT_EQ(agreements[0].trials, 1);
  EXPECT_EQ(agreements[2].trials, 1);
}

}  // namespace
}  // namespace foveola::study
