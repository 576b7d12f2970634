#include "renderer/trace/bsdf.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "reference_bsdf.h"
#include "renderer/base/random.h"
#include "statistics.h"

namespace foveola {
namespace {

struct Case {
  ReferenceMaterial material;
  double cosine = 1.0;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double roughness : {0.2, 0.5, 1.0}) {
    for (const double metallic : {0.0, 0.4, 1.0}) {
      for (const double cosine : {0.98, 0.5, 0.1}) {
        all.push_back({{.base = 0.7, .metallic = metallic, .roughness = roughness}, cosine});
      }
    }
  }
  return all;
}

Vec3 direction_of(double cosine) { return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}; }

Reflectance reflectance_of(const ReferenceMaterial& material) {
  return {.base_color = Rgb(static_cast<float>(material.base)),
          .metallic = static_cast<float>(material.metallic),
          .roughness = static_cast<float>(material.roughness)};
}

Vec3 uniform_hemisphere(Pcg32& random) {
  const double z = random.uniform();
  const double azimuth = 2.0 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

Vec2 unit_square(Pcg32& random) {
  const float x = unit_float(random.next());
  const float y = unit_float(random.next());
  return {x, y};
}

class BsdfTest : public testing::Test {
 protected:
  static const CoatAlbedo& table() {
    static const CoatAlbedo made_once(Workers(2));
    return made_once;
  }
  const CoatAlbedo& coat = table();
};

TEST_F(BsdfTest, ValueIsTheModelsFormula) {
  Pcg32 random(1);
  for (const double roughness : {0.2, 0.5, 1.0}) {
    const ReferenceCoat reference_coat(roughness * roughness);
    for (const double metallic : {0.0, 0.4, 1.0}) {
      const ReferenceMaterial material{.base = 0.7, .metallic = metallic, .roughness = roughness};
      for (int i = 0; i < 200; ++i) {
        const Vec3 outgoing = uniform_hemisphere(random);
        const Vec3 incoming = uniform_hemisphere(random);
        const Bsdf bsdf(reflectance_of(material), outgoing, coat);
        const double expected =
            reference_bsdf(material, reference_coat, outgoing, incoming) * incoming.z;
        const double exactness = std::min(outgoing.z, incoming.z) < 0.05F ? 0.03 : 0.003;
        EXPECT_NEAR(bsdf.eval(incoming).times_cosine.g, expected, exactness * expected)
            << roughness << ' ' << metallic << ' ' << outgoing.z << ' ' << incoming.z;
      }
    }
  }
}

TEST_F(BsdfTest, IsReciprocal) {
  Pcg32 random(2);
  for (const Case& c : cases()) {
    const Vec3 outgoing = direction_of(c.cosine);
    for (int i = 0; i < 50; ++i) {
      const Vec3 incoming = uniform_hemisphere(random);
      const Reflectance reflectance = reflectance_of(c.material);
      const float there = Bsdf(reflectance, outgoing, coat).eval(incoming).times_cosine.r;
      const float back = Bsdf(reflectance, incoming, coat).eval(outgoing).times_cosine.r;
      EXPECT_NEAR(there / incoming.z, back / outgoing.z, 1e-4F * there / incoming.z);
    }
  }
}

TEST_F(BsdfTest, NothingComesFromBelow) {
  const Bsdf bsdf({}, Vec3(0, 0, 1), coat);
  EXPECT_EQ(bsdf.eval(Vec3(0.6F, 0.0F, -0.8F)).times_cosine, Rgb(0.0F));
  EXPECT_EQ(bsdf.eval(Vec3(0.6F, 0.0F, -0.8F)).pdf, 0.0F);
}

TEST_F(BsdfTest, SamplesCarryTheirValueOverTheirDensity) {
  Pcg32 random(3);
  for (const Case& c : cases()) {
    const Bsdf bsdf(reflectance_of(c.material), direction_of(c.cosine), coat);
    for (int i = 0; i < 50; ++i) {
      const float u_lobe = unit_float(random.next());
      const auto sample = bsdf.sample(u_lobe, unit_square(random));
      if (!sample) {
        continue;
      }
      const BsdfValue value = bsdf.eval(sample->incoming);
      EXPECT_FLOAT_EQ(sample->pdf, value.pdf);
      EXPECT_NEAR(sample->weight.r, value.times_cosine.r / value.pdf, 1e-5F);
    }
  }
}

/// Counts of sampled directions, and of those that the density predicts, in a grid over the
/// hemisphere; the last bin is for samples that ended below it.
struct Histograms {
  std::vector<double> observed;
  std::vector<double> expected;
};

Histograms histograms_of(const Bsdf& bsdf, int samples, Pcg32& random) {
  constexpr int rings = 24;
  constexpr int sectors = 48;
  // Of the quadrature, within a bin. Seen at grazing angles a smooth lobe is narrow in azimuth.
  constexpr int rings_in_bin = 12;
  constexpr int sectors_in_bin = 60;
  Histograms h{std::vector<double>(rings * sectors + 1), std::vector<double>(rings * sectors + 1)};
  for (int i = 0; i < samples; ++i) {
    const float u_lobe = unit_float(random.next());
    const auto sample = bsdf.sample(u_lobe, unit_square(random));
    if (!sample) {
      h.observed.back() += 1.0;
      continue;
    }
    const Vec3& w = sample->incoming;
    const int ring =
        std::min(rings - 1, static_cast<int>(std::acos(w.z) * 2.0 / std::numbers::pi * rings));
    const int sector = std::min(
        sectors - 1,
        static_cast<int>((std::atan2(w.y, w.x) / (2.0 * std::numbers::pi) + 0.5) * sectors));
    h.observed[static_cast<std::size_t>(ring * sectors + sector)] += 1.0;
  }
  const double theta_step = 0.5 * std::numbers::pi / (rings * rings_in_bin);
  const double phi_step = 2.0 * std::numbers::pi / (sectors * sectors_in_bin);
  double inside = 0.0;
  for (int i = 0; i < rings * rings_in_bin; ++i) {
    const double theta = (i + 0.5) * theta_step;
    for (int k = 0; k < sectors * sectors_in_bin; ++k) {
      const double phi = (k + 0.5) * phi_step - std::numbers::pi;
      const Vec3 w(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                   std::cos(theta));
      const double probability = bsdf.eval(w).pdf * std::sin(theta) * theta_step * phi_step;
      h.expected[static_cast<std::size_t>(i / rings_in_bin * sectors + k / sectors_in_bin)] +=
          samples * probability;
      inside += probability;
    }
  }
  h.expected.back() = samples * std::max(0.0, 1.0 - inside);
  return h;
}

TEST_F(BsdfTest, SamplesFollowTheirDensity) {
  constexpr int samples = 40000;
  Pcg32 random(4);
  const std::vector<Case> all = cases();
  const double level = sidak_level(static_cast<int>(all.size()));
  for (const Case& c : all) {
    const Bsdf bsdf(reflectance_of(c.material), direction_of(c.cosine), coat);
    const Histograms h = histograms_of(bsdf, samples, random);
    EXPECT_GT(chi_squared_p_value(h.observed, h.expected), level)
        << c.material.roughness << ' ' << c.material.metallic << ' ' << c.cosine;
  }
}

TEST_F(BsdfTest, ReflectsTheModelsAlbedoAndNeverMoreThanAllLight) {
  Pcg32 random(5);
  for (const double roughness : {0.0, 0.05, 0.1, 0.3, 0.6, 1.0}) {
    for (const double metallic : {0.0, 0.5, 1.0}) {
      for (const double cosine : {1.0, 0.6, 0.2, 0.03}) {
        const ReferenceMaterial material{
            .base = 1.0, .metallic = metallic, .roughness = std::max(roughness, std::sqrt(1e-3))};
        const Reflectance reflectance{.base_color = Rgb(1.0F),
                                      .metallic = static_cast<float>(metallic),
                                      .roughness = static_cast<float>(roughness)};
        const Bsdf bsdf(reflectance, direction_of(cosine), coat);
        MeanEstimate albedo;
        for (int i = 0; i < 4000; ++i) {
          const float u_lobe = unit_float(random.next());
          const auto sample = bsdf.sample(u_lobe, unit_square(random));
          albedo.add(sample ? sample->weight.r : 0.0);
        }
        expect_mean(albedo, reference_albedo(material, cosine), 2e-3, 0.02);
        EXPECT_LE(albedo.mean(), 1.001 + 5.0 * albedo.standard_error());
      }
    }
  }
}

TEST_F(BsdfTest, BlackMetalAtNormalIncidenceIsFinite) {
  const Bsdf bsdf({.base_color = Rgb(0.0F), .metallic = 1.0F, .roughness = 0.5F}, Vec3(0, 0, 1),
                  coat);
  const auto sample = bsdf.sample(0.5F, Vec2(0.3F, 0.6F));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(is_finite(sample->weight));
}

TEST_F(BsdfTest, GrazingDirectionsStayFinite) {
  for (const float roughness : {0.0F, 0.3F, 1.0F}) {
    const Bsdf bsdf({.roughness = roughness}, Vec3(1.0F, 0.0F, 1e-12F), coat);
    const auto sample = bsdf.sample(0.99F, Vec2(0.1F, 0.5F));
    ASSERT_TRUE(sample);
    EXPECT_TRUE(is_finite(sample->weight));
    EXPECT_TRUE(is_finite(bsdf.eval(Vec3(-1.0F, 0.0F, 1e-12F)).times_cosine));
  }
}

}  // namespace
}  // namespace foveola
