#include "renderer/stability/closed_forms.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace foveola {
namespace {

using std::numbers::pi;

/// The irradiance at `point`, by the midpoint rule over the parallelogram.
double quadrature(const DVec3& corner, const DVec3& a, const DVec3& b, const DVec3& point,
                  const DVec3& normal) {
  constexpr int steps = 1000;
  const DVec3 area = glm::cross(a, b) / static_cast<double>(steps * steps);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const DVec3 to = corner + (i + 0.5) / steps * a + (k + 0.5) / steps * b - point;
      sum += glm::dot(to, normal) * std::abs(glm::dot(to, area)) / std::pow(glm::dot(to, to), 2.0);
    }
  }
  return sum;
}

TEST(ClosedFormsTest, PolygonIrradianceIsItsQuadrature) {
  const DVec3 corner(0.3, 0.8, -0.2);
  const DVec3 a(1.0, 0.4, 0.1);
  const DVec3 b(-0.2, 0.3, 1.2);
  const DVec3 normal = glm::normalize(DVec3(0.2, 1.0, 0.1));
  const std::array<DVec3, 4> corners{corner, corner + a, corner + a + b, corner + b};
  EXPECT_NEAR(std::abs(polygon_irradiance(corners, DVec3(0.0), normal)),
              quadrature(corner, a, b, DVec3(0.0), normal), 1e-5);
}

TEST(ClosedFormsTest, RectangleFormFactorIsItsQuadrature) {
  const double factor = corner_rectangle_form_factor(2.0, 0.5, 1.5);
  EXPECT_NEAR(
      factor * pi,
      quadrature(DVec3(0, 1.5, 0), DVec3(2, 0, 0), DVec3(0, 0, 0.5), DVec3(0.0), DVec3(0, 1, 0)),
      1e-6);
  // Four quarters of everything.
  EXPECT_NEAR(corner_rectangle_form_factor(1e6, 1e6, 1.0), 0.25, 1e-6);
}

TEST(ClosedFormsTest, FresnelHasItsTextbookValues) {
  EXPECT_NEAR(fresnel_reflectance(1.0, 1.5), 0.04, 1e-12);
  EXPECT_NEAR(fresnel_reflectance(1.0, 1.0 / 1.5), 0.04, 1e-12);
  EXPECT_EQ(fresnel_reflectance(0.7, 1.0 / 1.5), 1.0);  // beyond the critical angle
  EXPECT_NEAR(fresnel_reflectance(0.0, 1.5), 1.0, 1e-12);
  // At Brewster's angle only the wave across the plane of incidence is reflected.
  const double brewster = std::atan(1.5);
  const double across = std::pow(std::sin(brewster - (0.5 * pi - brewster)), 2.0);
  EXPECT_NEAR(fresnel_reflectance(std::cos(brewster), 1.5), 0.5 * across, 1e-12);
}

TEST(ClosedFormsTest, SlabSharesAreTheSumOfTheirReflections) {
  const GlassSlab slab{.ior = 1.6, .thickness_m = 0.2, .attenuation_per_m = 1.5};
  const double cosine = 0.5;
  const double path = 0.2 / std::sqrt(1.0 - (1.0 - cosine * cosine) / (1.6 * 1.6));
  const double r = fresnel_reflectance(cosine, 1.6);
  double transmitted = 0.0;
  double reflected = r;
  double inside = 1.0 - r;
  for (int face = 0; face < 60; ++face) {
    inside *= std::exp(-1.5 * path);
    (face % 2 == 0 ? transmitted : reflected) += (1.0 - r) * inside;
    inside *= r;
  }
  EXPECT_NEAR(slab_shares(slab, cosine).transmitted, transmitted, 1e-12);
  EXPECT_NEAR(slab_shares(slab, cosine).reflected, reflected, 1e-12);
  const SlabShares clear = slab_shares({.ior = 1.5}, 0.3);
  EXPECT_NEAR(clear.transmitted + clear.reflected, 1.0, 1e-12);
}

}  // namespace
}  // namespace foveola
