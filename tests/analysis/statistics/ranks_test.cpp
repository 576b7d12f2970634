#include "analysis/statistics/correlation.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Ranks, EqualValuesShareTheMeanOfTheirRanks) {
  const Ranks ranks = rank(std::vector<double>{7, -1, 7, 3, 7, 3});
  EXPECT_THAT(ranks.ranks, ElementsAre(5, 1, 5, 2.5, 5, 2.5));
  EXPECT_EQ(ranks.tie_correction, (27 - 3) + (8 - 2));
}

TEST(Ranks, WithoutTiesNothingIsCorrected) {
  EXPECT_THAT(rank(std::vector<double>{1e300, -1e300, 0}).ranks, ElementsAre(3, 1, 2));
  EXPECT_EQ(rank(std::vector<double>{1e300, -1e300, 0}).tie_correction, 0.0);
  EXPECT_THAT(rank(std::vector<double>{}).ranks, IsEmpty());
}

}  // namespace
}  // namespace foveola::analysis
