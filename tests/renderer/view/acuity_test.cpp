#include "renderer/view/acuity.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/view/eccentricity_table.h"

namespace foveola {
namespace {

constexpr double pi = std::numbers::pi;

/// The integral of 2 pi e m(e) de over [0, e] by Simpson's rule on both sides of the knee, with the
/// acuity written out anew from the paper's eq. 1.
double integral_by_quadrature(double eccentricity_deg) {
  const auto density = [](double e, bool beyond) {
    const double acuity = beyond ? 7.49 / std::pow(0.3 * e + 1.0, 2) : 1.0;
    return 2.0 * pi * e * acuity;
  };
  const auto simpson = [&](double a, double b, bool beyond) {
    constexpr int n = 2000;
    const double h = (b - a) / n;
    double sum = density(a, beyond) + density(b, beyond);
    for (int i = 1; i < n; ++i) {
      sum += density(a + i * h, beyond) * (i % 2 == 1 ? 4.0 : 2.0);
    }
    return sum * h / 3.0;
  };
  return eccentricity_deg <= 5.79
             ? simpson(0.0, eccentricity_deg, false)
             : simpson(0.0, 5.79, false) + simpson(5.79, eccentricity_deg, true);
}

TEST(ReddyAcuity, IsOneInTheFoveaAndFallsBeyond) {
  EXPECT_EQ(reddy_acuity(0.0), 1.0);
  EXPECT_EQ(reddy_acuity(5.79), 1.0);
  EXPECT_NEAR(reddy_acuity(5.7900001), 1.0, 1.7e-4);  // the paper's constants join to 1.6e-4
  EXPECT_NEAR(reddy_acuity(20.0), 7.49 / 49.0, 1e-12);
  EXPECT_NEAR(reddy_acuity(80.0), 7.49 / 625.0, 1e-12);
}

TEST(FoveatedDistribution, NormaliserIsThePapers) {
  EXPECT_NEAR(FoveatedDistribution().cumulative(80.0), 1091.85, 0.005);
}

TEST(FoveatedDistribution, CumulativeIsTheIntegralOfTheDensity) {
  const FoveatedDistribution distribution;
  for (const double e : {0.1, 3.0, 5.78, 5.79, 5.8, 10.0, 45.0, 79.0, 80.0}) {
    const double expected = integral_by_quadrature(e);
    EXPECT_NEAR(distribution.cumulative(e), expected, 1e-9 * expected) << e;
  }
  EXPECT_EQ(distribution.cumulative(0.0), 0.0);
}

TEST(FoveatedDistribution, InverseIsExactEverywhere) {
  const FoveatedDistribution distribution;
  const double total = integral_by_quadrature(80.0);
  for (int i = 0; i <= 2000; ++i) {
    const double u = i / 2000.0;
    const double e = distribution.eccentricity_deg(u);
    EXPECT_NEAR(integral_by_quadrature(e) / total, u, 1e-9) << "at " << e;
  }
  EXPECT_EQ(distribution.eccentricity_deg(0.0), 0.0);
  EXPECT_NEAR(distribution.eccentricity_deg(1.0), 80.0, 1e-9);
}

// The paper's polynomial jumps from 5.7904 to 5.7949 degrees at u = 0.0965; the inverse does not.
TEST(FoveatedDistribution, HasNoGapAtTheKnee) {
  const FoveatedDistribution distribution;
  const double knee = pi * 5.79 * 5.79 / integral_by_quadrature(80.0);
  const double below = distribution.eccentricity_deg(knee - 1e-9);
  const double above = distribution.eccentricity_deg(knee + 1e-9);
  EXPECT_NEAR(below, 5.79, 1e-6);
  EXPECT_NEAR(above, 5.79, 1e-6);
  EXPECT_LE(below, above);
}

TEST(FoveatedDistribution, DensityIsThatOfARingOnTheSphere) {
  const FoveatedDistribution distribution;
  for (const double e : {1e-6, 2.0, 5.0, 6.0, 30.0, 79.0}) {
    const double h = 1e-4;
    const double low = std::max(e - h, 0.0);
    const double mass = integral_by_quadrature(e + h) - integral_by_quadrature(low);
    const double ring_sr = 2.0 * pi * (std::cos(radians(low)) - std::cos(radians(e + h)));
    EXPECT_NEAR(distribution.density_per_sr(e) * ring_sr * integral_by_quadrature(80.0) / mass, 1.0,
                1e-4)
        << e;
  }
  EXPECT_EQ(distribution.density_per_sr(80.1), 0.0);
}

TEST(FoveatedDistribution, OtherCutOffsAreNormalised) {
  for (const double cutoff : {3.0, 5.79, 40.0}) {
    const FoveatedDistribution distribution(cutoff);
    EXPECT_NEAR(distribution.eccentricity_deg(1.0), cutoff, 1e-9);
    const double half = distribution.eccentricity_deg(0.5);
    EXPECT_NEAR(integral_by_quadrature(half) / integral_by_quadrature(cutoff), 0.5, 1e-9);
  }
}

TEST(EccentricityTable, IsWithinAMillionthOfTheExactInverse) {
  for (const double cutoff : {80.0, 30.0, 4.0}) {
    const FoveatedDistribution distribution(cutoff);
    const EccentricityTable table(distribution);
    for (int i = 1; i <= 200'000; ++i) {
      const float u = static_cast<float>(i) / 200'000.0F;
      const double exact = radians(distribution.eccentricity_deg(u));
      ASSERT_NEAR(table(u), exact, 1e-6 * exact) << u << " of " << cutoff;
    }
    EXPECT_EQ(table(0.0F), 0.0F);
  }
}

}  // namespace
}  // namespace foveola
