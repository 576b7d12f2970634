#include "renderer/view/foveated_samplers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

using std::numbers::pi;

// By hand: 18.64 sqrt(0.04) is 18.64 / 5, sqrt(0.0625) would be beyond the switch; at 0.5 the
// polynomial is 25.09 / 16 + 0.1680 / 8 + 27.61 / 4 + 23.87 / 2 + 3.232.
TEST(Equation7, IsAsPrinted) {
  const Equation7Distribution distribution;
  EXPECT_EQ(distribution.eccentricity_deg(0.0), 0.0);
  EXPECT_NEAR(distribution.eccentricity_deg(0.01), 1.864, 1e-12);
  EXPECT_NEAR(distribution.eccentricity_deg(0.04), 3.728, 1e-12);
  EXPECT_NEAR(distribution.eccentricity_deg(0.0965), 5.7904133186, 1e-9);
  EXPECT_NEAR(distribution.eccentricity_deg(0.0965 + 1e-12), 5.7948929473, 1e-9);
  EXPECT_NEAR(distribution.eccentricity_deg(0.1), 5.897777, 1e-12);
  EXPECT_NEAR(distribution.eccentricity_deg(0.5), 23.658625, 1e-12);
  EXPECT_NEAR(distribution.eccentricity_deg(1.0), 79.97, 1e-12);
  EXPECT_NEAR(distribution.cutoff_deg(), 79.97, 1e-12);
}

TEST(Equation7, RisesWithU) {
  const Equation7Distribution distribution;
  double previous = -1.0;
  for (int i = 0; i <= 100'000; ++i) {
    const double e = distribution.eccentricity_deg(i / 100'000.0);
    ASSERT_GT(e, previous) << i;
    previous = e;
  }
}

TEST(Equation7, CumulativeIsItsInverse) {
  const Equation7Distribution distribution;
  for (int i = 0; i <= 20'000; ++i) {
    const double u = i / 20'000.0;
    ASSERT_NEAR(distribution.cumulative(distribution.eccentricity_deg(u)), u, 1e-14) << u;
  }
  for (const double e : {5.7905, 5.792, 5.7948}) {
    EXPECT_EQ(distribution.cumulative(e), 0.0965) << e;
  }
  for (const double e : distribution.knees_deg()) {
    EXPECT_EQ(distribution.cumulative(e), 0.0965) << e;
  }
  EXPECT_EQ(distribution.cumulative(79.98), 1.0);
}

// By hand: 1 / (pi 18.64^2) = 9.16133e-4 a square degree at the gaze; at u = 0.5 the slope is
// 12.545 + 0.126 + 27.61 + 23.87 = 64.151 degrees, the radius 23.658625.
TEST(Equation7, DensityIsThatOfItsRadii) {
  const Equation7Distribution distribution;
  const double square_degrees_per_sr = (180.0 / pi) * (180.0 / pi);
  EXPECT_NEAR(distribution.density_per_sr(0.0) / (9.16133e-4 * square_degrees_per_sr), 1.0, 1e-5);
  const double e = radians(23.658625);
  const double planar = 1.0 / (2.0 * pi * 23.658625 * 64.151);
  EXPECT_NEAR(
      distribution.density_per_sr(23.658625) / (planar * square_degrees_per_sr * e / std::sin(e)),
      1.0, 1e-12);
  for (const double nothing : {5.7905, 5.792, 5.7948, 79.971, 100.0}) {
    EXPECT_EQ(distribution.density_per_sr(nothing), 0.0) << nothing;
  }
}

TEST(Equation7, DensityIntegratesToOne) {
  const Equation7Distribution distribution;
  double sum = 0.0;
  // By the midpoint rule on either side of the gap.
  const auto add = [&](double from, double to) {
    constexpr int steps = 20'000;
    const double step = (to - from) / steps;
    for (int i = 0; i < steps; ++i) {
      const double e = from + (i + 0.5) * step;
      sum += distribution.density_per_sr(e) * 2.0 * pi * std::sin(radians(e)) * radians(step);
    }
  };
  add(0.0, distribution.knees_deg().front());
  EXPECT_NEAR(sum, 0.0965, 1e-9);
  add(distribution.knees_deg().back(), distribution.cutoff_deg());
  EXPECT_NEAR(sum, 1.0, 1e-7);
}

// Every float around the switch: the table that samplers draw from keeps to either branch, up to
// the rounding of a float.
TEST(Equation7, TheTableDoesNotSmearTheGap) {
  const Equation7Distribution distribution;
  const EccentricityTable table(distribution);
  float u = 0.0955F;
  int below = 0;
  int above = 0;
  while (u < 0.0975F) {
    const double e = 360.0 * table(u);
    ASSERT_NEAR(e / distribution.eccentricity_deg(u), 1.0, 1e-6) << u;
    ++(e < 5.7925 ? below : above);
    u = std::nextafter(u, 1.0F);
  }
  EXPECT_GT(below, 100'000);
  EXPECT_GT(above, 100'000);
}

constexpr AzimuthElevation heading{.azimuth_rad = 0.7, .elevation_rad = -0.3};
const Vec3 heading_direction = direction_from(heading);

std::unique_ptr<ViewSampler> aimed(const char* method) {
  std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim(
      {.viewport = Viewport(head_orientation(heading), 1.7, 1.7), .gaze = heading_direction});
  return sampler;
}

/// Counts independent samples of a method in bins of eccentricity, which `bin_of` finds.
std::vector<double> counted(const char* method, std::size_t samples_in_all, std::size_t bins,
                            const std::function<std::size_t(double e_deg)>& bin_of) {
  const std::unique_ptr<ViewSampler> sampler = aimed(method);
  std::vector<double> counts(bins, 0.0);
  Pcg32 generator(7);
  std::vector<Vec2> points(1 << 14);
  std::vector<ViewSample> samples(points.size());
  for (std::size_t done = 0; done < samples_in_all; done += points.size()) {
    for (Vec2& point : points) {
      const float x = unit_float(generator.next());
      point = {x, unit_float(generator.next())};
    }
    sampler->sample(points, samples);
    for (const ViewSample& sample : samples) {
      counts[bin_of(degrees(angle_between(sample.direction, heading_direction)))] += 1.0;
    }
  }
  return counts;
}

TEST(Equation7, NoSampleFallsInTheGap) {
  // Directions are floats, to a few millionths of a degree.
  const auto in_gap = [](double e) -> std::size_t { return e > 5.79043 && e < 5.79488 ? 1 : 0; };
  constexpr std::size_t samples = 1 << 20;
  EXPECT_EQ(counted("fv-paper", samples, 2, in_gap)[1], 0.0);
  // 2 pi 5.7926 0.00445 of 1091.85 square degrees: 155 +- 12.
  EXPECT_NEAR(counted("fv", samples, 2, in_gap)[1], 155.0, 50.0);
}

/// Pearson's chi-squared test of fv-paper's samples in rings, each of which has an equal share of
/// them if `distribution` is theirs.
double p_value_in_rings(const RadialDistribution& distribution) {
  constexpr std::size_t rings = 64;
  constexpr std::size_t samples = 1 << 23;
  std::vector<double> ends_deg;
  for (std::size_t i = 1; i < rings; ++i) {
    ends_deg.push_back(distribution.eccentricity_deg(static_cast<double>(i) / rings));
  }
  const std::vector<double> counts = counted("fv-paper", samples, rings, [&](double e) {
    return static_cast<std::size_t>(std::upper_bound(ends_deg.begin(), ends_deg.end(), e) -
                                    ends_deg.begin());
  });
  double statistic = 0.0;
  constexpr double expected = static_cast<double>(samples) / rings;
  for (const double count : counts) {
    statistic += (count - expected) * (count - expected) / expected;
  }
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(rings - 1), statistic));
}

TEST(Equation7, SamplesFollowItAndNotTheExactInverse) {
  EXPECT_GT(p_value_in_rings(Equation7Distribution()), 0.01);
  EXPECT_LT(p_value_in_rings(ReddyDistribution(80.0)), 1e-5);
}

// No part of a hybrid divides by the density of another.
TEST(Equation7, AHybridHasTheOthersDensityInTheGap) {
  const Vec3 in_gap =
      Frame(heading_direction)
          .to_world(Vec3(std::sin(radians(5.7926)), 0.0, std::cos(radians(5.7926))));
  EXPECT_EQ(aimed("fv-paper")->density_per_sr(in_gap), 0.0);
  EXPECT_EQ(aimed("hybrid:0.5*fv-paper+0.5*od")->density_per_sr(in_gap),
            0.5 * aimed("od")->density_per_sr(in_gap));
}

// A pixel or patch whose middle lies in the gap is reached.
TEST(DensityAround, SeesBeyondAThinRing) {
  const auto fv = aimed("fv");
  const auto paper = aimed("fv-paper");
  for (int i = 0; i < 16; ++i) {
    const double azimuth = 2.0 * pi * i / 16.0;
    for (const double e : {5.7905, 5.7926, 5.7948}) {
      const double radius = std::sin(radians(e));
      const Vec3 in_gap = Frame(heading_direction)
                              .to_world(Vec3(radius * std::cos(azimuth), radius * std::sin(azimuth),
                                             std::cos(radians(e))));
      ASSERT_EQ(paper->density_per_sr(in_gap), 0.0);
      EXPECT_NEAR(density_around(*paper, in_gap) / fv->density_per_sr(in_gap), 1.0, 0.03);
    }
  }
  const Vec3 elsewhere = -heading_direction;
  EXPECT_EQ(density_around(*paper, elsewhere), 0.0);
  EXPECT_EQ(density_around(*paper, heading_direction), paper->density_per_sr(heading_direction));
}

using std::numbers::pi;

/// Watson's eq. 8 anew, in cells per square degree along the meridian k of his table 1.
double cells(int k, double r) {
  const double a[] = {0.9851, 0.9935, 0.9729, 0.996};
  const double r2[] = {1.058, 1.035, 1.084, 0.9932};
  const double re[] = {22.14, 16.35, 7.633, 12.13};
  return 2.0 * 14804.6 / (1.0 + r / 41.03) *
         (a[k] * std::pow(1.0 + r / r2[k], -2.0) + (1.0 - a[k]) * std::exp(-r / re[k]));
}

/// At (x, y) degrees to the right of and above the gaze, where the rows called superior (1) and
/// inferior (3) are of the retina, which sees the lower and the upper field: the spacings of a
/// quadrant's two meridians are the half-axes of an ellipse.
double right_eye(double x, double y) {
  const double r = std::hypot(x, y);
  const double spacing_x = 1.0 / std::sqrt(cells(x >= 0.0 ? 0 : 2, r));
  const double spacing_y = 1.0 / std::sqrt(cells(y >= 0.0 ? 3 : 1, r));
  const double spacing = std::sqrt(std::pow(x * spacing_x, 2) + std::pow(y * spacing_y, 2)) / r;
  return 1.0 / (spacing * spacing);
}

double model(Eyes eyes, double x, double y) {
  const double right = right_eye(x, y);
  const double left = right_eye(-x, y);
  return eyes == Eyes::right ? right : eyes == Eyes::left ? left : 0.5 * (right + left);
}

/// The model's integral over 80 degrees by the midpoint rule, in rings that grow from the gaze on.
double integral(Eyes eyes) {
  constexpr int rings = 2000;
  constexpr int sectors = 400;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double t = (i + 0.5) / rings;
    const double r = 80.0 * t * t * t;
    const double step = 80.0 * 3.0 * t * t / rings;
    for (int j = 0; j < sectors; ++j) {
      const double angle = 2.0 * pi * (j + 0.5) / sectors;
      sum += model(eyes, r * std::cos(angle), r * std::sin(angle)) * r * step;
    }
  }
  return sum * 2.0 * pi / sectors;
}

TEST(WatsonDensity, IsThePapersRelativeToTheGaze) {
  for (int k = 0; k < 4; ++k) {
    for (const double r : {0.0, 0.5, 5.0, 30.0, 80.0}) {
      EXPECT_NEAR(watson_density(static_cast<Meridian>(k), r), cells(k, r) / (2.0 * 14804.6),
                  1e-12);
    }
  }
  // By hand at 10 degrees towards the temple: (0.9851 / 10.4518^2 + 0.0149 e^-0.45167) / 1.24372.
  EXPECT_NEAR(watson_density(Meridian::temporal, 10.0), 0.01487673, 2e-8);
}

// In the periphery the superior retina has 60 % more ganglion cells than the inferior (Curcio and
// Allen 1990), and sees the lower visual field (Kupers et al. 2022, fig. 2). So samples fall below
// the gaze rather than above it; Watson's formula has 1.2 to 1.6 times as many from 10 to 40
// degrees.
TEST(WatsonSampler, LooksDownBetterThanUp) {
  for (const Eyes eyes : {Eyes::right, Eyes::left, Eyes::both}) {
    WatsonSampler sampler(eyes, 1.0, 80.0, EccentricityMeasure::planar);
    sampler.aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
    for (const double e : {10.0, 15.0, 20.0, 30.0, 40.0}) {
      const double below = sampler.density_per_sr(direction_from({.elevation_rad = -radians(e)}));
      const double above = sampler.density_per_sr(direction_from({.elevation_rad = radians(e)}));
      EXPECT_GT(below / above, 1.2) << e;
      EXPECT_LT(below / above, 1.7) << e;
    }
  }
}

constexpr Eyes all_eyes[] = {Eyes::right, Eyes::left, Eyes::both};

TEST(WatsonSampler, StatedDensityIsTheModelsUpToTheCutOff) {
  const Quat head = head_orientation({.azimuth_rad = 0.4, .elevation_rad = 0.3});
  const Vec3 gaze = head * Vec3(0.0F, 0.0F, -1.0F);
  for (const Eyes eyes : all_eyes) {
    WatsonSampler sampler(eyes, 1.0, 80.0, EccentricityMeasure::planar);
    sampler.aim({.viewport = Viewport(head, 1.0, 1.0), .gaze = gaze});
    const double total = integral(eyes);
    double worst = 0.0;
    for (const double e : {0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 30.0, 60.0, 79.9}) {
      for (int degree = 0; degree < 360; ++degree) {
        const double angle = radians(degree + 0.5);
        const double sine = std::sin(radians(e));
        const Vec3 direction =
            head * Vec3(sine * std::cos(angle), sine * std::sin(angle), -std::cos(radians(e)));
        const double expected = model(eyes, e * std::cos(angle), e * std::sin(angle)) / total *
                                radians(e) / sine * std::pow(180.0 / pi, 2);
        worst = std::max(worst, std::abs(sampler.density_per_sr(direction) / expected - 1.0));
      }
    }
    EXPECT_LT(worst, 1e-4);
  }
}

// With the head on its side, up is where its top points.
TEST(WatsonSampler, MeridiansTurnWithTheHead) {
  const Quat upright(1.0F, 0.0F, 0.0F, 0.0F);
  const Quat on_its_right_side =
      glm::angleAxis(static_cast<float>(-pi / 2.0), Vec3(0.0F, 0.0F, 1.0F));
  const Vec3 gaze(0.0F, 0.0F, -1.0F);
  const Vec3 right(std::sin(0.5F), 0.0F, -std::cos(0.5F));
  const Vec3 up(0.0F, std::sin(0.5F), -std::cos(0.5F));
  for (const Eyes eyes : all_eyes) {
    WatsonSampler level(eyes, 1.0, 80.0, EccentricityMeasure::planar);
    WatsonSampler tilted = level;
    level.aim({.viewport = Viewport(upright, 1.0, 1.0), .gaze = gaze});
    tilted.aim({.viewport = Viewport(on_its_right_side, 1.0, 1.0), .gaze = gaze});
    EXPECT_NEAR(tilted.density_per_sr(right) / level.density_per_sr(up), 1.0, 1e-5);
    EXPECT_NEAR(
        tilted.density_per_sr(-up + 2.0F * glm::dot(up, gaze) * gaze) / level.density_per_sr(right),
        1.0, 1e-5);
  }
}

TEST(WatsonSampler, RaisesTheMeridiansToTheExponent) {
  WatsonSampler sampler(Eyes::right, 2.0, 80.0, EccentricityMeasure::planar);
  sampler.aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  const double e = radians(20.0);
  const double ratio = sampler.density_per_sr(direction_from({.azimuth_rad = e})) /
                       sampler.density_per_sr(direction_from({.azimuth_rad = -e}));
  EXPECT_NEAR(ratio, std::pow(cells(0, 20.0) / cells(2, 20.0), 2), 1e-4);
}

}  // namespace

}  // namespace foveola
