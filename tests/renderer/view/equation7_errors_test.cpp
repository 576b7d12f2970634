#include "renderer/view/equation7_errors.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

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

/// Where it has the share u, by bisection.
double exact_radius(double u) {
  double low = 0.0;
  double high = 80.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (integral(middle) < u * integral(80.0) ? low : high) = middle;
  }
  return low;
}

double equation7(double u) {
  return u <= 0.0965
             ? 18.64 * std::sqrt(u)
             : 25.09 * std::pow(u, 4) + 0.1680 * std::pow(u, 3) + 27.61 * u * u + 23.87 * u + 3.232;
}

TEST(Equation7Errors, JumpsWhereItsBranchesDoNotMeet) {
  const Equation7Errors errors = equation7_errors();
  EXPECT_NEAR(errors.gap_begin_deg, 5.7904, 5e-5);
  EXPECT_NEAR(errors.gap_end_deg, 5.7949, 5e-5);
  EXPECT_NEAR(errors.last_radius_deg, 79.97, 1e-9);
}

TEST(Equation7Errors, LargestErrorsAreThoseThatBisectionFinds) {
  const Equation7Errors errors = equation7_errors();
  double relative = 0.0;
  double share = 0.0;
  for (int i = 1; i <= 20'000; ++i) {
    const double u = i / 20'000.0;
    relative = std::max(relative, std::abs(equation7(u) / exact_radius(u) - 1.0));
    share = std::max(share, std::abs(u - integral(equation7(u)) / integral(80.0)));
  }
  EXPECT_NEAR(std::abs(errors.radius_relative.error), relative, 1e-7);
  EXPECT_NEAR(errors.radius_relative.error, -0.00224, 5e-6);
  EXPECT_NEAR(errors.radius_relative.u, 0.155, 0.002);
  EXPECT_NEAR(errors.radius_relative.eccentricity_deg, 7.61, 0.05);
  EXPECT_NEAR(std::abs(errors.share.error), share, 1e-7);
  // 79.97 of 80.
  EXPECT_NEAR(errors.radius_deg.error, -0.03, 1e-9);
  EXPECT_EQ(errors.radius_deg.u, 1.0);
}

// At the far end of the gap the slope of the radius is 4 25.09 u^3 + 3 0.1680 u^2 + 2 27.61 u +
// 23.87 = 29.2936101 with u = 0.0965, so the density is 1 / 29.2936101 a degree, where equation 2
// over its integral has 14.98 pi e / (0.3 e + 1)^2 / 1091.84949 = 0.0333065020.
TEST(Equation7Errors, TheDensityErrsMostBesideTheGap) {
  const Equation7Errors errors = equation7_errors();
  EXPECT_NEAR(errors.density_relative.error, 1.0 / 29.2936101 / 0.0333065020 - 1.0, 1e-7);
  EXPECT_NEAR(errors.density_relative.error, 0.025, 0.0005);
  EXPECT_EQ(errors.density_relative.eccentricity_deg, errors.gap_end_deg);
}

TEST(Equation7Errors, IntegralsAreThoseOfAFinerRule) {
  const Equation7Errors errors = equation7_errors();
  double mean = 0.0;
  double absolute = 0.0;
  double with_sign = 0.0;
  double relative = 0.0;
  constexpr int steps = 30'000;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double exact = exact_radius(u);
    const double difference = equation7(u) - exact;
    mean += exact / steps;
    with_sign += difference / steps;
    absolute += std::abs(difference) / steps;
    relative += std::abs(difference) / exact / steps;
  }
  EXPECT_NEAR(errors.mean_radius_deg, mean, 1e-6);
  EXPECT_NEAR(errors.signed_radius_difference_deg, with_sign, 1e-7);
  EXPECT_NEAR(errors.radius_difference_deg, absolute, 1e-7);
  EXPECT_NEAR(errors.relative_radius_difference, relative, 1e-8);
  // The paper's "less than 0.04 %" is true of the first and not of the second.
  EXPECT_LT(errors.radius_difference_deg, 0.0004 * errors.mean_radius_deg);
  EXPECT_GT(errors.relative_radius_difference, 0.0004);
}

// In thin rings. Half of it is the share of samples that are elsewhere than they should be.
TEST(Equation7Errors, TheDensitiesDifferByMoreThanTheRadii) {
  double sum = 0.0;
  double previous_share = 0.0;
  double previous_exact = 0.0;
  constexpr int rings = 20'000;
  for (int i = 1; i <= rings; ++i) {
    const double e = 80.0 * i / rings;
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 50; ++step) {
      const double middle = 0.5 * (low + high);
      (equation7(middle) < e ? low : high) = middle;
    }
    const double exact = integral(e) / integral(80.0);
    sum += std::abs((low - previous_share) - (exact - previous_exact));
    previous_share = low;
    previous_exact = exact;
  }
  EXPECT_NEAR(equation7_errors().density_difference, sum, 2e-5);
  EXPECT_NEAR(sum, 0.0028, 0.0001);
}

TEST(Equation7Errors, SharesWithinTheFoveaAreItsAreasOverTheNormalisers) {
  const Equation7Errors errors = equation7_errors();
  EXPECT_NEAR(errors.foveal_share, 5.79 * 5.79 / (18.64 * 18.64), 1e-12);
  EXPECT_NEAR(errors.exact_foveal_share, pi * 5.79 * 5.79 / integral(80.0), 1e-12);
}

// At 5.79, y = 2.737: (0.365363 + 1.006862) 166.4 pi - 612.3 beside pi 5.79^2 = 105.319.
TEST(Equation5Errors, ConstantsArePrintedRounded) {
  const Equation5Errors errors = equation5_errors();
  EXPECT_NEAR(errors.jump, (1.0 / 2.737 + std::log(2.737)) * 166.4 * pi - 612.3 - 105.319066, 1e-5);
  EXPECT_NEAR(errors.jump, -0.273, 0.0005);
  EXPECT_NEAR(errors.exact_normaliser, 1091.85, 0.005);
  EXPECT_NEAR(errors.exact_normaliser, integral(80.0), 1e-9);
  EXPECT_NEAR(errors.normaliser, (0.04 + std::log(25.0)) * 166.4 * pi - 612.3, 1e-9);
}

}  // namespace
}  // namespace foveola
