#include "renderer/trace/coat_albedo.h"

#include <gtest/gtest.h>

#include "reference_bsdf.h"
#include "renderer/trace/ggx.h"

namespace foveola {
namespace {

TEST(CoatAlbedoTest, IsTheIntegralOfTheCoat) {
  const CoatAlbedo coat(Workers(2));
  for (const float roughness : {0.035F, 0.21F, 0.5F, 0.77F, 1.0F}) {
    const CoatAlbedo::Row row = coat.row(roughness);
    const double alpha = roughness * roughness;
    for (const float cosine : {0.002F, 0.01F, 0.1F, 0.33F, 0.5F, 0.81F, 1.0F}) {
      EXPECT_NEAR(row.at(cosine), specular_albedo(0.04, alpha, cosine),
                  cosine < 0.05F ? 0.01 : 1e-3)
          << roughness << ' ' << cosine;
    }
    EXPECT_NEAR(row.mean(), ReferenceCoat(alpha).mean(), 3e-4) << roughness;
  }
}

TEST(CoatAlbedoTest, SmoothCoatReflectsByFresnel) {
  const CoatAlbedo coat(Workers(2));
  EXPECT_NEAR(coat.row(0.0F).at(1.0F), 0.04, 1e-4);
}

TEST(CoatAlbedoTest, MeanIsThatOfTheValuesGiven) {
  const CoatAlbedo coat(Workers(2));
  const CoatAlbedo::Row row = coat.row(0.63F);
  double mean = 0.0;
  constexpr int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    mean += 2.0 * row.at(static_cast<float>(cosine)) * cosine / steps;
  }
  EXPECT_NEAR(row.mean(), mean, 1e-6);
}

}  // namespace
}  // namespace foveola
