#include "renderer/trace/materials/bsdf.h"

#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/renderer/trace/bsdf_cases.h"
#include "tests/renderer/trace/random_points.h"

namespace foveola {
namespace {

using test::unit_square;

Bsdf bsdf_of(const ReferenceMaterial& material, const Vec3& outgoing) {
  return Bsdf(reflectance_of(material), outgoing, scattering_tables());
}

/// Of a material without its smooth clearcoat, which no pair of directions meets.
double expected_value(ReferenceMaterial material, const ReferenceCoat& coat, const Vec3& o,
                      const Vec3& in, double glass) {
  double scale = 1.0;
  if (material.clearcoat > 0.0 && material.clearcoat_roughness == 0.0) {
    scale = 1.0 - material.clearcoat * reference_schlick(0.04, 1.0, o.z);
    material.clearcoat = 0.0;
  }
  return scale * std::abs(in.z) * reference_bsdf(material, coat, o, in, glass);
}

void expect_formula(const std::string& name, const ReferenceChannels& channels,
                    const ReferenceCoat& coat, Pcg32& random) {
  const ReferenceMaterial& material = channels[0];
  for (int i = 0; i < 3; ++i) {
    const Vec3 o = uniform_hemisphere(random);
    const Bsdf bsdf(reflectance_of(channels), o, scattering_tables());
    const double glass =
        material.is_solid ? glass_albedo(material.eta(), material.alpha(), o.z) : 1.0;
    for (int k = 0; k < 5; ++k) {
      const Vec3 above = uniform_hemisphere(random);
      for (const Vec3 in : {above, Vec3(above.x, above.y, -above.z)}) {
        if (in.z < 0.0F && material.transmission == 0.0) {
          continue;
        }
        for (int c = 0; c < 3; ++c) {
          const double expected =
              expected_value(channels[static_cast<std::size_t>(c)], coat, o, in, glass);
          const double exactness = std::min(o.z, above.z) < 0.05F ? 0.01 : 0.003;
          EXPECT_NEAR(bsdf.eval(in).times_cosine[c], expected, exactness * expected + 1e-7)
              << name << ' ' << material.roughness << ' ' << o.z << ' ' << in.z << ' ' << c;
        }
      }
    }
  }
}

TEST(BsdfTest, ValueIsTheModelsFormula) {
  Pcg32 random(1);
  std::map<std::array<double, 3>, ReferenceCoat> coats;
  for (const double roughness : {0.2, 0.6, 1.0}) {
    for (const auto& [name, material] : every_kind(0.7, roughness)) {
      for (const ReferenceChannels& channels : {grey(material), coloured(material)}) {
        const ReferenceMaterial& m = channels[0];
        const ReferenceCoat& coat =
            coats.try_emplace({roughness, m.brightest_f0(), m.f90()}, m).first->second;
        expect_formula(name, channels, coat, random);
      }
    }
  }
}

TEST(BsdfTest, WithoutSpecularItIsLambertian) {
  Pcg32 random(2);
  for (const Reflectance& reflectance :
       {Reflectance{.base_color = Rgb(0.8F, 0.5F, 0.1F), .roughness = 0.3F, .specular = 0.0F},
        Reflectance{.base_color = Rgb(0.8F, 0.5F, 0.1F), .roughness = 0.0F, .ior = 1.0F}}) {
    for (int i = 0; i < 100; ++i) {
      const Vec3 in = uniform_hemisphere(random);
      const Bsdf bsdf(reflectance, uniform_hemisphere(random), scattering_tables());
      const Rgb value = bsdf.eval(in).times_cosine;
      for (int c = 0; c < 3; ++c) {
        EXPECT_FLOAT_EQ(value[c], reflectance.base_color[c] * in.z / std::numbers::pi_v<float>);
      }
      const auto sample = bsdf.sample(unit_float(random.next()), unit_square(random));
      ASSERT_TRUE(sample);
      EXPECT_FLOAT_EQ(sample->weight.r, 0.8F);
      EXPECT_FLOAT_EQ(sample->weight.b, 0.1F);
    }
  }
}

TEST(BsdfTest, CoatOverDiffuseIsReciprocal) {
  Pcg32 random(3);
  for (const double roughness : {0.02, 0.2, 1.0}) {
    const ReferenceMaterial material{.base = 0.7, .roughness = roughness};
    for (int i = 0; i < 200; ++i) {
      const Vec3 o = uniform_hemisphere(random);
      const Vec3 in = uniform_hemisphere(random);
      const float there = bsdf_of(material, o).eval(in).times_cosine.r;
      const float back = bsdf_of(material, in).eval(o).times_cosine.r;
      EXPECT_NEAR(there / in.z, back / o.z, 2e-5F * there / in.z);
    }
  }
}

TEST(BsdfTest, WithoutTransmissionNothingComesFromBelow) {
  const Bsdf bsdf({}, Vec3(0, 0, 1), scattering_tables());
  EXPECT_EQ(bsdf.eval(Vec3(0.6F, 0.0F, -0.8F)).times_cosine, Rgb(0.0F));
  EXPECT_EQ(bsdf.eval(Vec3(0.6F, 0.0F, -0.8F)).pdf, 0.0F);
}

TEST(BsdfTest, SamplesCarryTheirValueOverTheirDensity) {
  Pcg32 random(4);
  for (const auto& [name, material] : every_kind(0.7, 0.3)) {
    for (const double cosine : {0.98, 0.5, 0.1}) {
      const Bsdf bsdf = bsdf_of(material, direction_of(cosine));
      for (int i = 0; i < 50; ++i) {
        const float u_lobe = unit_float(random.next());
        const auto sample = bsdf.sample(u_lobe, unit_square(random));
        if (!sample || sample->is_specular) {
          continue;
        }
        const BsdfValue value = bsdf.eval(sample->incoming);
        EXPECT_FLOAT_EQ(sample->pdf, value.pdf);
        EXPECT_NEAR(sample->weight.r, value.times_cosine.r / value.pdf, 1e-5F) << name;
        const float eta = static_cast<float>(material.eta());
        const bool is_refracted = material.is_solid && sample->incoming.z < 0.0F;
        EXPECT_FLOAT_EQ(sample->radiance_scale, is_refracted ? 1.0F / (eta * eta) : 1.0F);
      }
    }
  }
}

TEST(BsdfTest, EveryInputGivesFiniteSamples) {
  constexpr float almost_one = 0x1.fffffep-1F;
  for (const double roughness : {0.0, 0.001, 0.0099, 0.01, 0.03, 0.5, 1.0}) {
    for (const double base : {0.0, 1.0}) {
      for (const auto& [name, material] : every_kind(base, roughness)) {
        for (const float cosine : {1e-30F, 1e-6F, 1e-3F, 0.5F, 1.0F}) {
          const Bsdf bsdf = bsdf_of(material, direction_of(cosine));
          for (const float u_lobe : {0.0F, 0.25F, 0.5F, 0.75F, almost_one}) {
            for (const float x : {0.0F, 0.5F, almost_one}) {
              for (const float y : {0.0F, 1e-7F, 0.5F, almost_one}) {
                const auto sample = bsdf.sample(u_lobe, Vec2(x, y));
                if (!sample) {
                  continue;
                }
                EXPECT_TRUE(is_finite(sample->incoming) && is_finite(sample->weight) &&
                            std::isfinite(sample->pdf) && sample->pdf > 0.0F)
                    << name << ' ' << roughness << ' ' << cosine << ' ' << u_lobe << ' ' << x << ' '
                    << y;
                EXPECT_NEAR(glm::length(sample->incoming), 1.0F, 1e-5F);
                EXPECT_GE(std::min({sample->weight.r, sample->weight.g, sample->weight.b}), 0.0F);
              }
            }
          }
        }
      }
    }
  }
}

TEST(BsdfTest, SmoothMetalMirrors) {
  const Vec3 o = glm::normalize(Vec3(0.3F, -0.5F, 0.4F));
  const Bsdf bsdf({.base_color = Rgb(0.9F, 0.5F, 0.2F), .metallic = 1.0F, .roughness = 0.005F}, o,
                  scattering_tables());
  const auto sample = bsdf.sample(0.7F, Vec2(0.3F, 0.6F));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->is_specular);
  EXPECT_EQ(sample->incoming, Vec3(-o.x, -o.y, o.z));
  EXPECT_FLOAT_EQ(sample->pdf, 1.0F);
  EXPECT_NEAR(sample->weight.r, reference_schlick(0.9, 1.0, o.z), 1e-6);
  EXPECT_NEAR(sample->weight.b, reference_schlick(0.2, 1.0, o.z), 1e-6);
  EXPECT_EQ(bsdf.eval(sample->incoming).pdf, 0.0F);
}

TEST(BsdfTest, SmoothGlassRefractsBySnellsLaw) {
  for (const bool from_inside : {false, true}) {
    for (const double cosine : {0.95, 0.8, 0.3, 0.02}) {
      const ReferenceMaterial glass{.base = 0.8,
                                    .roughness = 0.0,
                                    .transmission = 1.0,
                                    .is_solid = true,
                                    .from_inside = from_inside};
      const double eta = glass.eta();
      const double fresnel = reference_fresnel(cosine, eta);
      const double sine = std::sqrt(1.0 - cosine * cosine) / eta;
      const Bsdf bsdf = bsdf_of(glass, direction_of(cosine));
      for (const float u_lobe : {0.0F, 0.9999F}) {
        const auto sample = bsdf.sample(u_lobe, Vec2(0.3F, 0.6F));
        ASSERT_TRUE(sample);
        EXPECT_TRUE(sample->is_specular);
        const bool is_reflected = u_lobe == 0.0F || fresnel == 1.0;
        EXPECT_EQ(sample->incoming.z > 0.0F, is_reflected);
        if (is_reflected) {
          EXPECT_NEAR(sample->pdf, fresnel, 1e-5);
          EXPECT_NEAR(sample->weight.g, 1.0, 1e-5);
          EXPECT_EQ(sample->radiance_scale, 1.0F);
        } else {
          EXPECT_NEAR(sample->incoming.x, -sine, 1e-6);
          EXPECT_NEAR(sample->incoming.z, -std::sqrt(1.0 - sine * sine), 1e-5);
          EXPECT_NEAR(sample->pdf, 1.0 - fresnel, 1e-5);
          EXPECT_NEAR(sample->weight.g, 0.8 / (eta * eta), 1e-5);
          EXPECT_NEAR(sample->radiance_scale, 1.0 / (eta * eta), 1e-6);
        }
      }
    }
  }
}

TEST(BsdfTest, GlassLikeItsSurroundingsIsNotThere) {
  for (const double roughness : {0.0, 0.4}) {
    for (const double cosine : {1.0, 0.5, 1e-3}) {
      const Vec3 o = direction_of(cosine);
      const Bsdf bsdf = bsdf_of(
          {.base = 0.8, .roughness = roughness, .ior = 1.0, .transmission = 1.0, .is_solid = true},
          o);
      const auto sample = bsdf.sample(0.0F, Vec2(0.3F, 0.6F));
      ASSERT_TRUE(sample);
      EXPECT_LT(glm::distance(sample->incoming, -o), 1e-6F);
      EXPECT_FLOAT_EQ(sample->weight.g, 0.8F);
    }
  }
}

TEST(BsdfTest, SmoothWallLetsStraightThrough) {
  const Vec3 o = glm::normalize(Vec3(0.3F, -0.5F, 0.2F));
  const Bsdf bsdf = bsdf_of({.base = 0.8, .roughness = 0.0, .transmission = 1.0}, o);
  const double fresnel = reference_schlick(0.04, 1.0, o.z);
  const double transmitted = 0.8 * (1.0 - fresnel);
  const auto through = bsdf.sample(0.9999F, Vec2(0.3F, 0.6F));
  ASSERT_TRUE(through);
  EXPECT_EQ(through->incoming, -o);
  EXPECT_EQ(through->radiance_scale, 1.0F);
  EXPECT_NEAR(through->weight.g * through->pdf, transmitted, 1e-5);
  const auto back = bsdf.sample(0.0F, Vec2(0.3F, 0.6F));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->incoming, Vec3(-o.x, -o.y, o.z));
  EXPECT_NEAR(back->weight.g * back->pdf, fresnel, 1e-5);
}

TEST(BsdfTest, SmoothGlassIsReciprocalUpToEtaSquared) {
  const ReferenceMaterial outside{
      .base = 0.8, .roughness = 0.0, .transmission = 1.0, .is_solid = true};
  ReferenceMaterial inside = outside;
  inside.from_inside = true;
  const auto in = bsdf_of(outside, direction_of(0.6)).sample(0.9999F, Vec2(0.5F));
  ASSERT_TRUE(in && in->incoming.z < 0.0F);
  const auto out = bsdf_of(inside, -in->incoming).sample(0.9999F, Vec2(0.5F));
  ASSERT_TRUE(out && out->incoming.z < 0.0F);
  EXPECT_LT(glm::distance(Vec3(out->incoming.x, 0.0F, -out->incoming.z),
                          Vec3(-direction_of(0.6).x, 0.0F, 0.6F)),
            1e-5F);
  EXPECT_NEAR(in->weight.g * in->pdf * 2.25, out->weight.g * out->pdf / 2.25, 1e-5);
}

/// Seen in its own frame, a clear coat over nothing is the same whatever the base's normal is.
TEST(BsdfTest, AClearCoatScattersInItsOwnFrame) {
  const Reflectance coat{
      .base_color = Rgb(0.0F), .specular = 0.0F, .clearcoat = 1.0F, .clearcoat_roughness = 0.4F};
  const Vec3 normal = glm::normalize(Vec3(0.5F, -0.3F, 0.8F));
  const Frame frame(normal);
  const Vec3 outgoing = glm::normalize(Vec3(0.4F, 0.5F, 0.6F));
  const Bsdf tilted(coat, outgoing, scattering_tables(), normal);
  const Bsdf upright(coat, frame.to_local(outgoing), scattering_tables());
  Pcg32 random(8);
  int beyond_the_horizon = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 in = uniform_hemisphere(random);
    const Vec3 in_base = frame.to_world(in);
    beyond_the_horizon += in_base.z < 0.0F ? 1 : 0;
    const BsdfValue expected = upright.eval(in);
    const BsdfValue value = tilted.eval(in_base, /*is_reflected=*/true);
    EXPECT_NEAR(value.times_cosine.g, expected.times_cosine.g,
                1e-4F * expected.times_cosine.g + 1e-6F);
    EXPECT_NEAR(value.pdf, expected.pdf, 1e-4F * expected.pdf + 1e-6F);
    EXPECT_EQ(tilted.eval(in_base, /*is_reflected=*/false).pdf, 0.0F);
    if (const auto sample =
            tilted.sample(unit_float(random.next()), {0.3F, unit_float(random.next())})) {
      EXPECT_FALSE(sample->is_transmitted);
      EXPECT_NEAR(sample->pdf, tilted.eval(sample->incoming, true).pdf, 1e-5F * sample->pdf);
    }
  }
  EXPECT_GT(beyond_the_horizon, 100);
}

TEST(BsdfTest, ASmoothClearCoatMirrorsAboutItsOwnNormal) {
  const Reflectance coat{.base_color = Rgb(0.0F), .specular = 0.0F, .clearcoat = 1.0F};
  const Vec3 normal = glm::normalize(Vec3(0.2F, 0.1F, 1.0F));
  const Vec3 outgoing(0.6F, 0.0F, 0.8F);
  const auto sample = Bsdf(coat, outgoing, scattering_tables(), normal).sample(0.5F, Vec2(0.5F));
  ASSERT_TRUE(sample);
  const float cosine = glm::dot(outgoing, normal);
  EXPECT_NEAR(glm::distance(sample->incoming, 2.0F * cosine * normal - outgoing), 0.0, 1e-6);
  EXPECT_NEAR(sample->weight.g, 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0), 1e-5);
}

}  // namespace
}  // namespace foveola
