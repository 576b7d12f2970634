// How far the paper's equations 5 and 7 are from what they stand for, as docs/VALIDATION.md says.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/view/foveated_samplers.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// The integral of equation 2 in closed form: with y = 0.3 e + 1 that of e / y^2 is
/// (ln y + 1 / y) / 0.09.
double integral(double e) {
  const auto of_tail = [](double x) { return std::log(0.3 * x + 1.0) + 1.0 / (0.3 * x + 1.0); };
  return e <= 5.79 ? pi * e * e
                   : pi * 5.79 * 5.79 + 14.98 * pi / 0.09 * (of_tail(e) - of_tail(5.79));
}

const ReddyDistribution exact(80.0);
const Equation7Distribution approximate;

TEST(Equation7Errors, JumpsWhereItsBranchesDoNotMeet) {
  EXPECT_NEAR(approximate.knees_deg().front(), 5.7904, 5e-5);
  EXPECT_NEAR(approximate.knees_deg().back(), 5.7949, 5e-5);
  EXPECT_NEAR(approximate.cutoff_deg(), 79.97, 1e-9);
}

// The paper states "the maximum approximation error", 1.8 %, but not of what.
TEST(Equation7Errors, TheRadiusErrsByUpTo0224PerCent) {
  double largest = 0.0;
  double where_u = 0.0;
  double share = 0.0;
  for (int i = 1; i <= 20'000; ++i) {
    const double u = i / 20'000.0;
    const double radius = approximate.eccentricity_deg(u);
    const double error = radius / exact.eccentricity_deg(u) - 1.0;
    if (std::abs(error) > std::abs(largest)) {
      largest = error;
      where_u = u;
    }
    share = std::max(share, std::abs(u - integral(radius) / integral(80.0)));
  }
  EXPECT_NEAR(largest, -0.00224, 5e-6);
  EXPECT_NEAR(where_u, 0.155, 0.002);
  EXPECT_NEAR(share, 0.000525, 5e-6);
}

// At the far end of the gap the slope of the radius is 4 25.09 u^3 + 3 0.1680 u^2 + 2 27.61 u +
// 23.87 = 29.2936101 with u = 0.0965, so the density is 1 / 29.2936101 a degree, where equation 2
// over its integral has 14.98 pi e / (0.3 e + 1)^2 / 1091.84949 = 0.0333065020.
TEST(Equation7Errors, TheDensityErrsMostBesideTheGap) {
  const double beside = approximate.knees_deg().back();
  const double error = approximate.density_per_sr(beside) / exact.density_per_sr(beside) - 1.0;
  EXPECT_NEAR(error, 1.0 / 29.2936101 / 0.0333065020 - 1.0, 1e-7);
  EXPECT_NEAR(error, 0.025, 0.0005);
  for (int i = 1; i <= 20'000; ++i) {
    const double e = approximate.eccentricity_deg(i / 20'000.0);
    ASSERT_LE(std::abs(approximate.density_per_sr(e) / exact.density_per_sr(e) - 1.0), error + 1e-9)
        << e;
  }
}

// "The integral of the difference", less than 0.04 %, is true of the first and of no other.
TEST(Equation7Errors, IntegralsOfTheDifference) {
  double mean = 0.0;
  double absolute = 0.0;
  double relative = 0.0;
  constexpr int steps = 30'000;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double radius = exact.eccentricity_deg(u);
    const double difference = std::abs(approximate.eccentricity_deg(u) - radius);
    mean += radius / steps;
    absolute += difference / steps;
    relative += difference / radius / steps;
  }
  EXPECT_NEAR(absolute / mean, 0.000327, 5e-7);
  EXPECT_GT(relative, 0.0004);
  // Over thin rings, the densities'. Half of it is the share of samples that are elsewhere.
  double densities = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double e = 80.0 * i / steps;
    const double end = e + 80.0 / steps;
    densities += std::abs(approximate.cumulative(end) - approximate.cumulative(e) -
                          (integral(end) - integral(e)) / integral(80.0));
  }
  EXPECT_NEAR(densities, 0.0028, 0.0001);
}

TEST(Equation7Errors, SharesWithinTheFoveaAreItsAreasOverTheNormalisers) {
  EXPECT_NEAR(approximate.cumulative(5.79), 5.79 * 5.79 / (18.64 * 18.64), 1e-12);
  EXPECT_NEAR(exact.cumulative(5.79), pi * 5.79 * 5.79 / integral(80.0), 1e-12);
}

// Equation 5's second branch as printed starts below its first, and misses the normaliser.
TEST(Equation5Errors, ConstantsArePrintedRounded) {
  const auto beyond_knee = [](double e) {
    const double y = 0.3 * e + 1.0;
    return (1.0 / y + std::log(y)) * 166.4 * pi - 612.3;
  };
  EXPECT_NEAR(beyond_knee(5.79) - pi * 5.79 * 5.79, -0.273, 0.0005);
  EXPECT_NEAR(exact.integral(80.0), 1091.85, 0.005);
  EXPECT_NEAR(exact.integral(80.0), integral(80.0), 1e-9);
  EXPECT_NEAR(beyond_knee(80.0), 1091.31, 0.005);
}

}  // namespace
}  // namespace foveola
