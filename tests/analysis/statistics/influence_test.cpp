
#include <gtest/gtest.h>

#include "analysis/statistics/models/crossed_model.h"
#include "analysis/statistics/rank_tests.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

double mean_of(std::span<const double> values) { return *mean(values); }

TEST(Influence, TheRangeIsThatOfAllSmallerStudies) {
  const std::vector<double> logs = {-0.7, -0.5, -0.9, 0.4, -0.6};
  const LeaveOneOut range = leave_one_out(logs, mean_of).value();
  EXPECT_EQ(range.without_low, 3U);
  EXPECT_DOUBLE_EQ(range.estimates.low, -2.7 / 4.0);
  EXPECT_EQ(range.without_high, 2U);
  EXPECT_DOUBLE_EQ(range.estimates.high, -1.4 / 4.0);
  // Medians of the Walsh averages, by hand: without 0.4, and without -0.9.
  const LeaveOneOut of_ranks =
      leave_one_out(logs, [](auto others) { return pseudo_median(others)->value; }).value();
  EXPECT_DOUBLE_EQ(of_ranks.estimates.low, -0.675);
  EXPECT_DOUBLE_EQ(of_ranks.estimates.high, -0.525);
}

// The estimate of the balanced crossed model is the mean of the participants' means.
TEST(Influence, OfTheCrossedModelTheRangeIsThatOfAllSmallerStudies) {
  const GoldenMatrix matrix = golden_matrices("models_samples.csv").at("interior_12x5");
  std::vector<double> means;
  const RepeatedMeasures data = complete_participants(matrix);
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    means.push_back(*mean(data.of(participant)));
  }
  const LeaveOneOut range = leave_one_out(means, mean_of).value();
  const auto without = [&](std::size_t participant) {
    GoldenMatrix others = matrix;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(participant));
    return crossed_model(complete_participants(others)).value().mean;
  };
  EXPECT_GOLDEN(range.estimates.low, without(range.without_low));
  EXPECT_GOLDEN(range.estimates.high, without(range.without_high));
}

TEST(Influence, TwoParticipantsHaveTheirOwnValuesAndOneHasNone) {
  const LeaveOneOut range = leave_one_out(std::vector<double>{0.25, 0.5}, mean_of).value();
  EXPECT_EQ(range.estimates.low, 0.25);
  EXPECT_EQ(range.without_low, 1U);
  EXPECT_EQ(range.estimates.high, 0.5);
  EXPECT_EQ(range.without_high, 0U);
  EXPECT_FALSE(leave_one_out(std::vector<double>{0.25}, mean_of));
}

}  // namespace
}  // namespace foveola::analysis
