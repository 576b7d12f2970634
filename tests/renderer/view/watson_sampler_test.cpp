#include "renderer/view/watson_sampler.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace foveola {
namespace {

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
