#include "analysis/statistics/models/additive_fit.h"

#include <cmath>

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// 3 participants under 2 conditions: 10, 20, 30 and 1, 2, with a residual pattern orthogonal to
/// both.
std::vector<TrialValue> small_study() {
  return {{0, 0, 11.5}, {0, 1, 11.5}, {1, 0, 20.5}, {1, 1, 22.5}, {2, 0, 31.0}, {2, 1, 32.0}};
}

TEST(AdditiveFit, ResidualsAreFreeOfParticipantsAndConditions) {
  const AdditiveFit fit(small_study());
  EXPECT_DOUBLE_EQ(fit.residual(0), 0.5);
  EXPECT_DOUBLE_EQ(fit.residual(1), -0.5);
  EXPECT_DOUBLE_EQ(fit.residual(2), -0.5);
  EXPECT_DOUBLE_EQ(fit.residual(3), 0.5);
  EXPECT_NEAR(fit.residual(4), 0.0, 1e-14);
  EXPECT_EQ(fit.degrees_of_freedom(), 2.0);
  EXPECT_DOUBLE_EQ(fit.standard_deviation(), std::sqrt(1.0 / 2.0));
  EXPECT_DOUBLE_EQ(fit.freedom(0), 1.0 - 1.0 / 2.0 - 1.0 / 3.0 + 1.0 / 6.0);
}

TEST(AdditiveFit, ATrialTakenOutIsPredictedByTheOthers) {
  AdditiveFit fit(small_study());
  fit.remove_trial(1);
  EXPECT_EQ(fit.size(), 5U);
  EXPECT_FALSE(fit.keeps(1));
  EXPECT_EQ(fit.degrees_of_freedom(), 1.0);
  // The others' conditions differ by 2 and by 1: 1.5 on average, and so would participant 0's.
  EXPECT_NEAR(fit.residual(1), -1.5, 1e-12);
  EXPECT_NEAR(fit.residual(0), 0.0, 1e-12);
  EXPECT_EQ(fit.freedom(0), 0.0);
}

TEST(AdditiveFit, OfNothingNothingIsLeft) {
  const AdditiveFit fit({});
  EXPECT_EQ(fit.size(), 0U);
}

}  // namespace
}  // namespace foveola::analysis
