#include <gtest/gtest.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "analysis/r_models/fit_models.h"

namespace foveola::analysis {
namespace {

ExpectedStudy planned_study() {
  ExpectedStudy expected = example_study();
  expected.protocol.analysis.primary = {{"material", "fv", "od"}};
  return expected;
}

TEST(FitStudies, FitThePlannedComparisonsOfEachStudy) {
  const ExpectedStudy expected = planned_study();
  const std::vector<study::StudyRecords> studies = {draw_study(expected, 8, 1),
                                                    draw_study(expected, 9, 2)};
  const std::vector<FittedModels> fitted = fit_studies(studies);
  ASSERT_EQ(fitted.size(), 2U);
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  for (std::size_t i = 0; i < studies.size(); ++i) {
    ASSERT_EQ(fitted[i].models.size(), 1U);
    const FittedModel* model = fitted[i].find("crossed", "material", "fv", "od");
    ASSERT_NE(model, nullptr);
    EXPECT_EQ(model->participants, 8 + i);
    const auto closed =
        planned_primary_analyses(select_for_analysis(studies[i]), expected.protocol.analysis);
    EXPECT_NEAR(model->fit->estimate, closed.front().primary->estimate, 1e-9);
  }
}

TEST(FitStudies, SayOfAStudyWithoutDataThatNothingWasFitted) {
  ExpectedStudy expected = planned_study();
  expected.withdrawals = 1.0;
  const std::vector<FittedModels> fitted = fit_studies({draw_study(expected, 4, 1)});
  ASSERT_EQ(fitted.size(), 1U);
  EXPECT_TRUE(fitted.front().models.empty());
  EXPECT_EQ(fitted.front().missing, "no session is completed");
}

}  // namespace
}  // namespace foveola::analysis
