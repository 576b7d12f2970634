#include "renderer/trace/materials/sheen.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderer/trace/reference_bsdf.h"

namespace foveola {
namespace {

TEST(SheenTest, ValueIsThePublishedFormula) {
  for (const float roughness : {0.0F, 0.1F, 0.4F, 1.0F}) {
    for (const double cosine : {0.02, 0.4, 0.9}) {
      const DVec3 o = direction_in_plane(cosine);
      const CharlieSheen sheen(roughness, Vec3(o));
      for (const double z : {0.03, 0.3, 0.8}) {
        for (const double azimuth : {0.3, 2.0, 3.0}) {
          const double r = std::sqrt(1.0 - z * z);
          const DVec3 i(r * std::cos(azimuth), r * std::sin(azimuth), z);
          const double expected = reference_sheen(o, i, roughness) * z;
          EXPECT_NEAR(sheen.times_cosine(Vec3(i)), expected, 2e-4 * expected + 1e-9);
        }
      }
    }
  }
}

// As the normal's own component along itself may be, after rounding.
TEST(SheenTest, CosinesThatAreRoundedUpAreOne) {
  const Vec3 beyond(0.0F, 0.0F, std::nextafter(1.0F, 2.0F));
  const Vec3 ahead(0.0F, 0.0F, 1.0F);
  const Vec3 slanted(0.6F, 0.0F, 0.8F);
  const CharlieSheen sheen(0.8F, beyond);
  const CharlieSheen exact(0.8F, ahead);
  EXPECT_NEAR(sheen.times_cosine(slanted), exact.times_cosine(slanted), 1e-6F);
  EXPECT_NEAR(CharlieSheen(0.8F, slanted).times_cosine(beyond),
              CharlieSheen(0.8F, slanted).times_cosine(ahead), 1e-6F);
  const SheenAlbedo table(Workers(2));
  EXPECT_NEAR(table.of(sheen, 0.8F, beyond.z), table.of(exact, 0.8F, 1.0F), 1e-5F);
}

TEST(SheenTest, AlbedoIsTheIntegral) {
  const SheenAlbedo table(Workers(2));
  for (const float roughness : {0.0F, 0.085F, 0.13F, 0.3F, 0.62F, 1.0F}) {
    for (const float cosine : {0.002F, 0.01F, 0.1F, 0.45F, 1.0F}) {
      const CharlieSheen sheen(roughness, Vec3(direction_in_plane(cosine)));
      const double expected = sheen_albedo(roughness, cosine);
      EXPECT_NEAR(table.of(sheen, roughness, cosine), expected, 1.5e-3 * std::max(expected, 0.5))
          << roughness << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace foveola
