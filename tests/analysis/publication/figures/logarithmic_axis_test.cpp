#include "analysis/publication/figures/logarithmic_axis.h"

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(LogarithmicAxis, TicksAreRoundNumbersWithinTheRange) {
  EXPECT_THAT(logarithmic_ticks({0.9, 130.0}), ElementsAre(1, 2, 5, 10, 20, 50, 100));
  EXPECT_THAT(logarithmic_ticks({0.15, 3.0}), ElementsAre(0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3));
  EXPECT_THAT(logarithmic_ticks({7.0, 100.0}), ElementsAre(7, 10, 15, 20, 30, 50, 70, 100));
  EXPECT_THAT(logarithmic_ticks({38.0, 155.0}), ElementsAre(40, 50, 60, 80, 100, 120, 150));
}

TEST(LogarithmicAxis, ManyDecadesHavePowersOfTenAndLessThanOneEqualSteps) {
  EXPECT_THAT(logarithmic_ticks({0.5, 20000.0}), ElementsAre(1, 10, 100, 1000, 10000));
  EXPECT_THAT(logarithmic_ticks({90.0, 112.0}),
              Pointwise(DoubleNear(1e-9), {90, 95, 100, 105, 110}));
}

TEST(LogarithmicAxis, NumbersHaveNoExponent) {
  EXPECT_EQ(plain_number(0.00002), "0.00002");
  EXPECT_EQ(plain_number(0.1 + 0.2), "0.3");
  EXPECT_EQ(plain_number(5.0), "5");
  EXPECT_EQ(plain_number(2000000.0), "2000000");
}

TEST(LogarithmicAxis, ReachesAllValuesAndFarIntervalsOnlyInPart) {
  EXPECT_FALSE(reach_of({}, {}));
  const Interval reach = reach_of({20.0, 40.0}, {{10.0, 50.0}, {0.001, 9000.0}}).value();
  // Up to 2.5 times the values, and 15 % more.
  EXPECT_DOUBLE_EQ(reach.low, 20.0 / 2.5 / 1.15);
  EXPECT_DOUBLE_EQ(reach.high, 40.0 * 2.5 * 1.15);
}

TEST(LogarithmicAxis, NoChangeIsOnAnAxisOfRatios) {
  EXPECT_DOUBLE_EQ(with_no_change({10.0, 20.0}).high, 105.0);
  EXPECT_DOUBLE_EQ(with_no_change({300.0, 400.0}).low, 100.0 / 1.05);
  EXPECT_DOUBLE_EQ(with_no_change({10.0, 400.0}).high, 400.0);
}

TEST(LogarithmicAxis, SpeedUpsStandAtTheirPerCent) {
  const std::string axes = relative_axes({9.0, 220.0}, "OD");
  EXPECT_THAT(axes, HasSubstr("set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200)"));
  EXPECT_THAT(axes, HasSubstr("('0.5×' 200, '1×' 100, '2×' 50, '5×' 20, '10×' 10)"));
  EXPECT_THAT(axes, HasSubstr("set xrange [9:220]"));
  EXPECT_THAT(axes, HasSubstr("set x2range [9:220]"));
}

}  // namespace
}  // namespace foveola::analysis
