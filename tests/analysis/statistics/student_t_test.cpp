#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/statistics/distributions.h"
#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

TEST(StudentT, QuantilesAreThoseOfR) {
  const auto golden = golden_statistics();
  for (const int df : {1, 2, 15, 1000}) {
    EXPECT_GOLDEN(student_t_quantile(0.95, df), golden.at(fmt::format("t{}.quantile_95", df)));
  }
}

TEST(StudentT, TailsAreThoseOfR) {
  const auto golden = golden_statistics();
  for (const int df : {1, 2, 15, 1000}) {
    const double expected = golden.at(fmt::format("t{}.two_sided_of_3", df));
    EXPECT_GOLDEN(student_t_two_sided(3.0, df), expected);
    EXPECT_GOLDEN(student_t_two_sided(-3.0, df), expected);
  }
}

TEST(StudentT, TailsAreRightFarOut) {
  const auto golden = golden_statistics();
  EXPECT_GOLDEN(student_t_two_sided(1e10, 30), golden.at("t30.two_sided_of_1e10"));
  EXPECT_GOLDEN(student_t_two_sided(80, 400), golden.at("t400.two_sided_of_80"));
  EXPECT_GOLDEN(student_t_two_sided(1e60, 5), golden_inference().at("tails.t_1e60_df_5"));
}

TEST(StudentT, TailsAtTheEnds) {
  EXPECT_EQ(student_t_two_sided(0.0, 5), 1.0);
  EXPECT_EQ(student_t_two_sided(std::numeric_limits<double>::infinity(), 5), 0.0);
}

}  // namespace
}  // namespace foveola::analysis
