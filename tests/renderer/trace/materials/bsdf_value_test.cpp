#include "renderer/trace/materials/bsdf_value.h"

#include <cmath>

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// Fresnel's equations in terms of angles (sines and tangents of their sum and difference).
double reflectance_of_angles(double incident, double refracted) {
  const double s = std::sin(incident - refracted) / std::sin(incident + refracted);
  const double p = std::tan(incident - refracted) / std::tan(incident + refracted);
  return 0.5 * (s * s + p * p);
}

TEST(FresnelTest, SplitIsThatOfTheAngles) {
  for (const double eta : {1.0 / 2.4, 1.0 / 1.5, 1.0 / 1.1, 1.1, 1.5, 2.4}) {
    for (const double incident : {0.1, 0.3, 0.41, 0.8, 1.1, 1.4, 1.56}) {
      const double sine = std::sin(incident) / eta;
      const FresnelSplit split =
          fresnel_split(static_cast<float>(std::cos(incident)), static_cast<float>(eta));
      if (sine > 1.0) {
        EXPECT_EQ(split.reflected, 1.0F);
        EXPECT_EQ(split.transmitted_cosine, 0.0F);
        continue;
      }
      const double refracted = std::asin(sine);
      EXPECT_NEAR(split.transmitted_cosine, std::cos(refracted), 2e-6) << eta << ' ' << incident;
      EXPECT_NEAR(split.reflected, reflectance_of_angles(incident, refracted), 3e-6)
          << eta << ' ' << incident;
    }
  }
}

TEST(FresnelTest, NormalIncidenceIsTheSquaredContrast) {
  EXPECT_NEAR(fresnel_split(1.0F, 1.5F).reflected, 0.04, 1e-7);
  EXPECT_NEAR(fresnel_split(1.0F, 1.0F / 1.5F).reflected, 0.04, 1e-7);
  EXPECT_NEAR(reflectance_at_normal(1.5F), 0.04, 1e-8);
  EXPECT_EQ(reflectance_at_normal(1.0F), 0.0F);
}

TEST(FresnelTest, GrazingLightIsReflected) {
  EXPECT_EQ(fresnel_split(0.0F, 1.5F).reflected, 1.0F);
  EXPECT_EQ(fresnel_split(0.0F, 0.6F).reflected, 1.0F);
}

TEST(FresnelTest, NoInterfaceDoesNothing) {
  for (const float cosine : {0.0F, 1e-4F, 0.3F, 1.0F}) {
    const FresnelSplit split = fresnel_split(cosine, 1.0F);
    EXPECT_EQ(split.reflected, 0.0F);
    EXPECT_EQ(split.transmitted_cosine, cosine);
  }
}

}  // namespace
}  // namespace foveola
