#include <gtest/gtest.h>

#include "renderer/trace/materials/scattering_tables.h"
#include "tests/renderer/trace/reference_bsdf.h"

namespace foveola {
namespace {

TEST(GlassAlbedoTest, IsTheIntegralOfBothLobes) {
  for (const float ior : {1.1F, 1.5F, 2.4F}) {
    const GlassAlbedo table(ior, Workers(2));
    for (const bool from_inside : {false, true}) {
      for (const float roughness : {0.05F, 0.3F, 0.6F, 1.0F}) {
        for (const float cosine : {0.01F, 0.2F, 0.5F, 0.76F, 1.0F}) {
          const double expected =
              glass_albedo(from_inside ? 1.0 / ior : ior,
                           static_cast<double>(roughness) * roughness, cosine, 600, 90);
          EXPECT_NEAR(table.at(roughness, cosine, from_inside), expected, 1.5e-3 * expected)
              << ior << ' ' << from_inside << ' ' << roughness << ' ' << cosine;
        }
      }
    }
  }
}

}  // namespace
}  // namespace foveola
