#include "analysis/statistics/influence.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/crossed_model.h"
#include "analysis/statistics/paired_t.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

TEST(Influence, TheRangeIsThatOfAllSmallerStudies) {
  const std::vector<double> logs = {-0.7, -0.5, -0.9, 0.4, -0.6};
  const LeaveOneOut range = leave_one_out(logs).value();
  EXPECT_EQ(range.without_low, 3U);
  EXPECT_DOUBLE_EQ(range.estimates.low, -2.7 / 4.0);
  EXPECT_EQ(range.without_high, 2U);
  EXPECT_DOUBLE_EQ(range.estimates.high, -1.4 / 4.0);
  double smallest = 1.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    std::vector<double> others = logs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    smallest = std::min(smallest, ratio_t(others)->logs.p);
    largest = std::max(largest, ratio_t(others)->logs.p);
  }
  EXPECT_DOUBLE_EQ(range.p->low, smallest);
  EXPECT_DOUBLE_EQ(range.p->high, largest);
}

TEST(Influence, OfTheCrossedModelTooTheRangeIsThatOfAllSmallerStudies) {
  const GoldenMatrix matrix = golden_matrices("models_samples.csv").at("interior_12x5");
  const LeaveOneOut range = leave_one_out(complete_participants(matrix)).value();
  const auto without = [&](std::size_t participant) {
    GoldenMatrix others = matrix;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(participant));
    return crossed_model(complete_participants(others)).value();
  };
  EXPECT_GOLDEN(range.estimates.low, without(range.without_low).mean);
  EXPECT_GOLDEN(range.estimates.high, without(range.without_high).mean);
  double smallest = 1.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const CrossedModel model = without(i);
    EXPECT_GE(model.mean, range.estimates.low - 1e-15);
    EXPECT_LE(model.mean, range.estimates.high + 1e-15);
    smallest = std::min(smallest, model.test->p);
    largest = std::max(largest, model.test->p);
  }
  EXPECT_GOLDEN(range.p->low, smallest);
  EXPECT_GOLDEN(range.p->high, largest);
}

TEST(Influence, WhereTheOthersDoNotVaryThereIsNoP) {
  const LeaveOneOut range = leave_one_out(std::vector<double>{0.5, 0.5, 0.75}).value();
  EXPECT_EQ(range.estimates.low, 0.5);
  EXPECT_EQ(range.without_low, 2U);
  EXPECT_FALSE(range.p);
}

TEST(Influence, TwoParticipantsHaveTheirOwnMeansAndOneHasNone) {
  const LeaveOneOut range = leave_one_out(std::vector<double>{0.25, 0.5}).value();
  EXPECT_EQ(range.estimates.low, 0.25);
  EXPECT_EQ(range.without_low, 1U);
  EXPECT_EQ(range.estimates.high, 0.5);
  EXPECT_EQ(range.without_high, 0U);
  EXPECT_FALSE(range.p);
  EXPECT_FALSE(leave_one_out(std::vector<double>{0.25}));
  EXPECT_FALSE(leave_one_out(RepeatedMeasures{2, 2, {0.1, 0.2, 0.3, 0.5}}));
  EXPECT_FALSE(leave_one_out(RepeatedMeasures{3, 1, {0.1, 0.2, 0.3}}));
}

}  // namespace
}  // namespace foveola::analysis
