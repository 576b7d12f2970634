#include "study/simulation/prediction_agreement.h"

#include <gtest/gtest.h>

#include "study/protocol/reading/read_procedure.h"

namespace foveola::study {
namespace {

Value timed(double number) { return {.state = Value::State::measured, .number = number}; }

/// One participant's study of the scenes hall and box.
StudyRecords study_of(const std::vector<std::string>& methods) {
  StudyRecords records;
  records.scenes = {"hall", "box"};
  records.methods = methods;
  records.measures = trial_measures(published_marks(), {});
  records.sessions.push_back({"P001", "simulated", "completed", {}, {}});
  return records;
}

void add_timed(StudyRecords& records, std::uint16_t scene, std::uint16_t method, double outline_s) {
  records.add_trial({.scene = scene, .method = method, .attempt = 1},
                    {timed(outline_s), timed(2.0 * outline_s)});
}

// By R's cor(method = "spearman").
TEST(PredictionAgreement, RanksAreCorrelatedAsByR) {
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {10.0, 30.0, 20.0, 40.0}), 0.8, 1e-12);
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 2.0, 4.0}, {4.0, 3.0, 2.0, 1.0}), -0.9486833, 1e-7);
  EXPECT_EQ(rank_correlation({1.0}, {2.0}), 0.0);
  EXPECT_EQ(rank_correlation({1.0, 1.0}, {2.0, 3.0}), 0.0);
}

TEST(PredictionAgreement, PairsTrialsWhateverTheirOrder) {
  StudyRecords rendered = study_of({"od", "fv"});
  add_timed(rendered, 0, 0, 8.0);
  add_timed(rendered, 1, 0, 4.0);
  add_timed(rendered, 0, 1, 1.0);
  StudyRecords predicted = study_of({"od", "fv"});
  add_timed(predicted, 0, 1, 1.5);
  add_timed(predicted, 0, 0, 8.8);
  add_timed(predicted, 1, 0, 4.0);
  add_timed(predicted, 1, 1, 0.5);
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
  StudyRecords rendered = study_of({"od"});
  add_timed(rendered, 0, 0, 8.0);
  add_timed(rendered, 1, 0, 4.0);
  StudyRecords predicted = rendered;
  rendered.values[0].state = Value::State::right_censored;
  predicted.values[3].state = Value::State::right_censored;
  const std::vector<MarkAgreement> agreements = prediction_agreement(rendered, predicted);
  EXPECT_EQ(agreements[0].trials, 1);
  EXPECT_EQ(agreements[2].trials, 1);
}

}  // namespace
}  // namespace foveola::study
