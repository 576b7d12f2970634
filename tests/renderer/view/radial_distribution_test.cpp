#include "renderer/view/radial_distribution.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/view/foveated_samplers.h"

namespace foveola {
namespace {

using std::numbers::pi;

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

TEST(ReddyDistribution, NormaliserIsThePapers) {
  EXPECT_NEAR(ReddyDistribution(80.0).integral(80.0), 1091.85, 0.005);
}

TEST(ReddyDistribution, CumulativeIsTheIntegralOfTheDensity) {
  const ReddyDistribution distribution(80.0);
  for (const double e : {0.1, 3.0, 5.78, 5.79, 5.8, 10.0, 45.0, 79.0, 80.0}) {
    const double expected = integral_by_quadrature(e);
    EXPECT_NEAR(distribution.integral(e), expected, 1e-9 * expected) << e;
  }
  EXPECT_EQ(distribution.cumulative(0.0), 0.0);
}

TEST(ReddyDistribution, InverseIsExactEverywhere) {
  const ReddyDistribution distribution(80.0);
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
TEST(ReddyDistribution, HasNoGapAtTheKnee) {
  const ReddyDistribution distribution(80.0);
  const double knee = pi * 5.79 * 5.79 / integral_by_quadrature(80.0);
  const double below = distribution.eccentricity_deg(knee - 1e-9);
  const double above = distribution.eccentricity_deg(knee + 1e-9);
  EXPECT_NEAR(below, 5.79, 1e-6);
  EXPECT_NEAR(above, 5.79, 1e-6);
  EXPECT_LE(below, above);
}

TEST(ReddyDistribution, DensityIsThatOfARingOnTheSphere) {
  const ReddyDistribution distribution(80.0);
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

TEST(ReddyDistribution, OtherCutOffsAreNormalised) {
  for (const double cutoff : {3.0, 5.79, 40.0}) {
    const ReddyDistribution distribution(cutoff);
    EXPECT_NEAR(distribution.eccentricity_deg(1.0), cutoff, 1e-9);
    const double half = distribution.eccentricity_deg(0.5);
    EXPECT_NEAR(integral_by_quadrature(half) / integral_by_quadrature(cutoff), 0.5, 1e-9);
  }
}

/// The integral of the density over the sphere up to an eccentricity, by the midpoint rule in steps
/// that grow from zero and from every knee: the fraction of samples below it, independently of
/// cumulative().
double mass_below(const RadialDistribution& distribution, double eccentricity_deg) {
  std::vector<double> ends = distribution.knees_deg();
  ends.push_back(eccentricity_deg);
  double mass = 0.0;
  double start = 0.0;
  for (const double knee : ends) {
    const double end = std::min(knee, eccentricity_deg);
    constexpr int steps = 40'000;
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps;
      const double e = start + (end - start) * t * t * t;
      const double step = (end - start) * 3.0 * t * t / steps;
      mass += distribution.density_per_sr(e) * 2.0 * pi * std::sin(radians(e)) * radians(step);
    }
    start = end;
  }
  return mass;
}

struct Named {
  const char* name;
  std::unique_ptr<RadialDistribution> distribution;
};

std::vector<Named> distributions() {
  constexpr auto planar = EccentricityMeasure::planar;
  constexpr auto solid = EccentricityMeasure::solid_angle;
  const auto make = [](AcuityModel model, double exponent, double cutoff_deg,
                       EccentricityMeasure measure) {
    return std::make_unique<AcuityDistribution>(std::move(model), exponent, cutoff_deg, measure);
  };
  std::vector<Named> all;
  all.push_back({"Reddy in closed form", std::make_unique<ReddyDistribution>(80.0)});
  all.push_back({"Reddy to 30", std::make_unique<ReddyDistribution>(30.0)});
  all.push_back({"Reddy to 4", std::make_unique<ReddyDistribution>(4.0)});
  all.push_back({"Reddy by quadrature", make(reddy_model(), 1.0, 80.0, planar)});
  all.push_back({"Reddy on the sphere", make(reddy_model(), 1.0, 80.0, solid)});
  all.push_back({"Reddy squared", make(reddy_model(), 2.0, 170.0, solid)});
  all.push_back({"Guenter", make(linear_resolution_model(0.022), 2.0, 80.0, planar)});
  all.push_back({"Guenter, steep", make(linear_resolution_model(1.0), 3.0, 120.0, solid)});
  all.push_back({"Weier's first", make(linear_fall_off_model(5.0, 10.0, 0.01), 1.0, 80.0, planar)});
  all.push_back({"Weier's third", make(linear_fall_off_model(15.0, 30.0, 0.1), 1.0, 80.0, solid)});
  all.push_back({"equation 7", std::make_unique<Equation7Distribution>()});
  return all;
}

TEST(RadialDistribution, CumulativeIsTheMassOfTheDensity) {
  for (const auto& [name, distribution] : distributions()) {
    SCOPED_TRACE(name);
    for (const double share : {0.02, 0.1, 0.5, 0.9, 1.0}) {
      const double e = share * distribution->cutoff_deg();
      EXPECT_NEAR(distribution->cumulative(e), mass_below(*distribution, e), 1e-7) << e;
    }
    EXPECT_EQ(distribution->cumulative(0.0), 0.0);
    EXPECT_EQ(distribution->density_per_sr(distribution->cutoff_deg() + 0.01), 0.0);
  }
}

TEST(RadialDistribution, InverseIsExact) {
  for (const auto& [name, distribution] : distributions()) {
    SCOPED_TRACE(name);
    for (int i = 0; i <= 1000; ++i) {
      const double u = i / 1000.0;
      EXPECT_NEAR(distribution->cumulative(distribution->eccentricity_deg(u)), u, 1e-11);
    }
    EXPECT_EQ(distribution->eccentricity_deg(0.0), 0.0);
    EXPECT_NEAR(distribution->eccentricity_deg(1.0), distribution->cutoff_deg(), 1e-9);
  }
}

TEST(AcuityDistribution, AgreesWithTheClosedForm) {
  const AcuityDistribution numerical(reddy_model(), 1.0, 80.0, EccentricityMeasure::planar);
  const ReddyDistribution exact(80.0);
  for (int i = 0; i <= 1000; ++i) {
    const double u = i / 1000.0;
    EXPECT_NEAR(numerical.eccentricity_deg(u), exact.eccentricity_deg(u), 1e-9);
  }
  for (const double e : {0.0, 3.0, 10.0, 79.0}) {
    EXPECT_NEAR(numerical.density_per_sr(e) / exact.density_per_sr(e), 1.0, 1e-12);
  }
}

TEST(EccentricityTable, IsWithinAMillionthOfTheExactInverse) {
  for (const auto& [name, distribution] : distributions()) {
    const EccentricityTable table(*distribution);
    double worst = 0.0;
    for (int i = 1; i < 50'000; ++i) {
      const float u = static_cast<float>(i) / 50'000.0F;
      const double exact = distribution->eccentricity_deg(u) / 360.0;
      worst = std::max(worst, std::abs(table(u) - exact) / exact);
    }
    for (const float u : {1e-12F, 1e-9F, 1e-7F, 1e-5F}) {
      const double exact = distribution->eccentricity_deg(u) / 360.0;
      worst = std::max(worst, std::abs(table(u) - exact) / exact);
    }
    EXPECT_LT(worst, 1e-6) << name;
    EXPECT_EQ(table(0.0F), 0.0F) << name;
  }
}

// From one float to the next across the knee at u = 0.0964 the radius grows by what the density
// says, nowhere by a ring that gets no samples.
TEST(EccentricityTable, HasNoGapAtTheKnee) {
  const ReddyDistribution distribution(80.0);
  const EccentricityTable table(distribution);
  const auto knee = static_cast<float>(distribution.cumulative(5.79));
  const double step =
      distribution.eccentricity_deg(knee + 1e-6) - distribution.eccentricity_deg(knee);
  float u = knee - 2e-4F;
  for (int i = 0; i < 50'000; ++i) {
    const float next = std::nextafter(u, 1.0F);
    // Per float of u the exact radius grows by the float's width; the table adds its own rounding.
    const double widest = 360.0 * 4e-9 + step * (next - u) / 1e-6;
    ASSERT_LE(360.0 * std::abs(table(next) - table(u)), widest) << u;
    u = next;
  }
  EXPECT_GT(u, knee + 1e-4F);
}

/// A relative density per square degree as published, written out anew, beside the distribution
/// that should follow it.
struct Published {
  std::string name;
  std::function<double(double e)> density;
  std::vector<double> knees_deg;
  AcuityModel model;
  double exponent = 1.0;
};

std::vector<Published> published() {
  const auto reddy = [](double e) { return e <= 5.79 ? 1.0 : 7.49 / std::pow(0.3 * e + 1.0, 2); };
  const auto linear = [](double inner, double outer, double least) {
    return [=](double e) {
      return e < inner ? 1.0 : e > outer ? least : 1 + (least - 1) * (e - inner) / (outer - inner);
    };
  };
  std::vector<Published> all;
  for (const double exponent : {1.0, 4.0, 5.0, 10.0}) {
    all.push_back({"Reddy", reddy, {5.79}, reddy_model(), exponent});
  }
  for (const double exponent : {2.0, 10.0}) {
    all.push_back({"Guenter",
                   [](double e) { return 1.0 / (1.0 + 48.0 * 0.022 * e); },
                   {},
                   linear_resolution_model(0.022),
                   exponent});
  }
  all.push_back({"linear to next to nothing",
                 linear(10.0, 20.0, 1e-6),
                 {10.0, 20.0},
                 linear_fall_off_model(10.0, 20.0, 1e-6),
                 3.0});
  all.push_back({"Weier's first",
                 linear(5.0, 10.0, 0.01),
                 {5.0, 10.0},
                 linear_fall_off_model(5.0, 10.0, 0.01),
                 1.0});
  // Watson 2014, eq. 8 with the rows temporal and superior of table 1, and their geometric mean.
  const auto watson = [](double e) {
    const double temporal =
        0.9851 * std::pow(1.0 + e / 1.058, -2) + (1.0 - 0.9851) * std::exp(-e / 22.14);
    const double superior =
        0.9935 * std::pow(1.0 + e / 1.035, -2) + (1.0 - 0.9935) * std::exp(-e / 16.35);
    return std::sqrt(temporal * superior) / (1.0 + e / 41.03);
  };
  const AcuityModel watson_model{.at =
                                     [](double e) {
                                       return std::sqrt(watson_density(Meridian::temporal, e) *
                                                        watson_density(Meridian::lower, e));
                                     },
                                 .knees_deg = {}};
  for (const double exponent : {1.0, 2.0, 3.0, 5.0}) {
    all.push_back({"Watson", watson, {}, watson_model, exponent});
  }
  return all;
}

/// Of `f` from one eccentricity to another by adaptive Gauss-Kronrod quadrature between the knees
/// and the powers of ten.
double adaptive_integral(const std::function<double(double e)>& f, double from, double to,
                         const std::vector<double>& knees_deg) {
  std::vector<double> ends{1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0, 40.0, to};
  ends.insert(ends.end(), knees_deg.begin(), knees_deg.end());
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (const double end : ends) {
    if (end > from && end <= to) {
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, end, 12, 1e-13);
      from = end;
    }
  }
  return sum;
}

// At u = 1 - 2^-k, down to the last float below 1: the samples beyond must be 2^-k of all, but for
// an error of the radius of a millionth.
TEST(EccentricityTable, HoldsToTheLastFloatBelowOne) {
  for (const Published& setting : published()) {
    for (const auto measure : {EccentricityMeasure::planar, EccentricityMeasure::solid_angle}) {
      for (const double cutoff_deg : {80.0, 179.0}) {
        const bool is_planar = measure == EccentricityMeasure::planar;
        SCOPED_TRACE(fmt::format("{} to the {}, {}, {} degrees", setting.name, setting.exponent,
                                 is_planar ? "planar" : "solid angle", cutoff_deg));
        const auto weight = [&](double e) {
          return (is_planar ? radians(e) : std::sin(radians(e))) *
                 std::pow(setting.density(e), setting.exponent);
        };
        const double total = adaptive_integral(weight, 0.0, cutoff_deg, setting.knees_deg);
        const EccentricityTable table(
            AcuityDistribution(setting.model, setting.exponent, cutoff_deg, measure));
        for (int k = 1; k <= 24; ++k) {
          const double beyond = std::exp2(-k);
          const double e = 360.0 * table(static_cast<float>(1.0 - beyond));
          const double found = adaptive_integral(weight, e, cutoff_deg, setting.knees_deg) / total;
          const double of_a_millionth = 1e-6 * e * weight(e) / total;
          EXPECT_NEAR(found, beyond, of_a_millionth + 1e-9 * beyond) << "1 - 2^-" << k;
        }
      }
    }
  }
}

TEST(EccentricityTable, ReachesBothEnds) {
  for (const auto& [name, distribution] : distributions()) {
    const EccentricityTable table(*distribution);
    EXPECT_EQ(table(0.0F), 0.0F) << name;
    const float last = 0x1.fffffep-1F;
    EXPECT_NEAR(360.0 * table(last) / distribution->eccentricity_deg(last), 1.0, 1e-6) << name;
    EXPECT_EQ(table(1.0F), table(last)) << name;
  }
}

// The tail beyond 40 degrees holds less than a double distinguishes from nothing.
TEST(AcuityDistribution, EndsAtTheCutOffHoweverThinTheTail) {
  const AcuityDistribution distribution(reddy_model(), 10.0, 80.0, EccentricityMeasure::planar);
  EXPECT_EQ(distribution.eccentricity_deg(1.0), 80.0);
  EXPECT_LT(distribution.eccentricity_deg(std::nextafter(1.0, 0.0)), 80.0);
}

}  // namespace
}  // namespace foveola
