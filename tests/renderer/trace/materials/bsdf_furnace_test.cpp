// The BSDF in a white furnace: lossless materials reflect and transmit all light, none more.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/renderer/trace/bsdf_cases.h"

namespace foveola {
namespace {

/// The sampled albedo, without the scaling of radiance. Strata of the lobe, each with a sequence of
/// its own: within 3e-4 of the expectation.
Rgb albedo_of(const Reflectance& reflectance, double cosine) {
  const Bsdf bsdf(reflectance, direction_of(cosine), scattering_tables());
  constexpr int lobe_strata = 64;
  constexpr std::uint32_t samples_in_stratum = 2048;
  Pcg32 random(6);
  DVec3 sum(0.0);
  for (int stratum = 0; stratum < lobe_strata; ++stratum) {
    for (std::uint32_t i = 0; i < samples_in_stratum; ++i) {
      const auto u_lobe = static_cast<float>((stratum + random.uniform()) / lobe_strata);
      const auto sample = bsdf.sample(std::min(u_lobe, 0x1.fffffep-1F),
                                      sobol_2d(i, static_cast<std::uint32_t>(stratum)));
      if (sample) {
        sum += DVec3(sample->weight / sample->radiance_scale);
      }
    }
  }
  return Rgb(sum / static_cast<double>(lobe_strata * samples_in_stratum));
}

TEST(BsdfFurnaceTest, LosslessMaterialsLoseNothing) {
  for (const double roughness : {0.001, 0.0105, 0.1, 0.45, 1.0}) {
    for (const auto& [name, material] : every_kind(1.0, roughness)) {
      for (const double cosine : {1.0, 0.2, 0.001}) {
        EXPECT_NEAR(albedo_of(reflectance_of(material), cosine).g, 1.0, 1e-3)
            << name << ' ' << roughness << ' ' << cosine;
      }
    }
  }
}

TEST(BsdfFurnaceTest, ColoursReflectNoMoreThanAllLight) {
  for (const double roughness : {0.001, 0.1, 0.45, 1.0}) {
    for (const auto& [name, material] : every_kind(1.0, roughness)) {
      Reflectance reflectance = reflectance_of(material);
      reflectance.base_color = Rgb(1.0F, 0.5F, 0.0F);
      reflectance.specular_color = Rgb(0.3F, 9.0F, 30.0F);
      for (const double cosine : {0.9, 0.1}) {
        EXPECT_LE(max_component(albedo_of(reflectance, cosine)), 1.0013)
            << name << ' ' << roughness << ' ' << cosine;
      }
    }
  }
}

TEST(BsdfFurnaceTest, AlbedoIsThatOfTheModel) {
  for (const double roughness : {0.1, 0.3, 1.0}) {
    for (const double metallic : {0.0, 0.5, 1.0}) {
      for (const double cosine : {1.0, 0.6, 0.2}) {
        const ReferenceMaterial material{.base = 0.6, .metallic = metallic, .roughness = roughness};
        EXPECT_NEAR(albedo_of(reflectance_of(material), cosine).g,
                    reference_albedo(material, cosine), 1.3e-3)
            << roughness << ' ' << metallic << ' ' << cosine;
      }
    }
  }
}

}  // namespace
}  // namespace foveola
