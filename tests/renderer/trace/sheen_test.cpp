#include "renderer/trace/sheen.h"

#include <numbers>

#include <gtest/gtest.h>

#include "reference_bsdf.h"

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
