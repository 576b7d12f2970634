#include "renderer/trace/materials/ggx_albedo.h"

#include <gtest/gtest.h>

#include "tests/renderer/trace/reference_bsdf.h"

namespace foveola {
namespace {

class GgxAlbedoTest : public testing::Test {
 protected:
  static const GgxAlbedo& table() {
    static const GgxAlbedo made_once(std::vector<RoughnessInterval>(1), Workers(2));
    return made_once;
  }
};

/// The midpoint rule of the oracle is good to 3e-4 where masking sets in.
TEST_F(GgxAlbedoTest, IsTheIntegralOfTheLobe) {
  for (const float roughness : {0.013F, 0.05F, 0.21F, 0.5F, 0.77F, 1.0F}) {
    const GgxAlbedo::Row row = table().row(roughness);
    const double alpha = roughness * roughness;
    for (const float cosine : {0.001F, 0.01F, 0.1F, 0.33F, 0.5F, 0.81F, 1.0F}) {
      const SchlickAlbedo albedo = row.at(cosine);
      for (const double f0 : {1.0, 0.04, 0.0}) {
        EXPECT_NEAR(albedo.with(static_cast<float>(f0), 1.0F),
                    specular_albedo(f0, 1.0, alpha, cosine), 8e-4)
            << roughness << ' ' << cosine << ' ' << f0;
      }
    }
  }
}

TEST_F(GgxAlbedoTest, AMirrorReflectsByFresnel) {
  for (const float roughness : {0.0F, 0.0099F}) {
    const GgxAlbedo::Row row = table().row(roughness);
    for (const float cosine : {1e-4F, 0.01F, 0.3F, 1.0F}) {
      EXPECT_NEAR(row.at(cosine).with(0.04F, 1.0F), reference_schlick(0.04, 1.0, cosine), 1e-6);
    }
    // 2 * integral of c (f0 + (1 - f0) (1 - c)^5).
    EXPECT_NEAR(row.mean().with(0.04F, 1.0F), 0.04 + 0.96 / 21.0, 1e-5);
  }
}

TEST_F(GgxAlbedoTest, MeanIsThatOfTheValuesGiven) {
  for (const float roughness : {0.0F, 0.02F, 0.1F, 0.3F, 0.63F, 1.0F}) {
    const GgxAlbedo::Row row = table().row(roughness);
    double white = 0.0;
    double grazing = 0.0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double cosine = (i + 0.5) / steps;
      const SchlickAlbedo albedo = row.at(static_cast<float>(cosine));
      white += 2.0 * albedo.white * cosine / steps;
      grazing += 2.0 * albedo.grazing * cosine / steps;
    }
    EXPECT_NEAR(row.mean().white, white, 1e-4) << roughness;
    EXPECT_NEAR(row.mean().grazing, grazing, 3e-5) << roughness;
  }
}

// Also where an interval is a node of the table, and at its end.
TEST_F(GgxAlbedoTest, OfSomeRoughnessesItIsTheSameToTheBit) {
  const std::vector<RoughnessInterval> some{{0.3F, 0.3F}, {0.5F, 0.55F}, {0.875F, 1.0F}};
  const GgxAlbedo partial(some, Workers(2));
  for (const float roughness : {0.0F, 0.3F, 0.5F, 0.52F, 0.55F, 0.875F, 0.9F, 1.0F}) {
    const GgxAlbedo::Row expected = table().row(roughness);
    const GgxAlbedo::Row row = partial.row(roughness);
    for (const float cosine : {0.01F, 0.5F, 1.0F}) {
      EXPECT_EQ(row.at(cosine).white, expected.at(cosine).white) << roughness << ' ' << cosine;
      EXPECT_EQ(row.at(cosine).grazing, expected.at(cosine).grazing) << roughness << ' ' << cosine;
    }
    EXPECT_EQ(row.mean().white, expected.mean().white) << roughness;
    EXPECT_EQ(row.mean().grazing, expected.mean().grazing) << roughness;
  }
}

}  // namespace
}  // namespace foveola
