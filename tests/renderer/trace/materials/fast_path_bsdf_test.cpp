#include "renderer/trace/materials/fast_path_bsdf.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderer/trace/bsdf_cases.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using test::unit_square;

/// Opaque, without covers, each of another kind.
std::array<ReferenceMaterial, lane_count> fast_path_materials(double roughness) {
  return {{{.base = 0.7, .metallic = 1.0, .roughness = roughness},
           {.base = 0.7, .roughness = roughness},
           {.base = 0.7, .metallic = 0.4, .roughness = roughness},
           {.base = 0.3, .roughness = roughness, .ior = 1.3, .specular = 0.7},
           {.base = 0.7, .roughness = roughness, .ior = 1.0},
           {.base = 0.7, .roughness = roughness, .specular = 0.0},
           {.base = 0.0, .roughness = roughness},
           {.base = 1.0, .metallic = 1.0, .roughness = roughness}}};
}

struct EightSurfaces {
  std::array<ReferenceMaterial, lane_count> materials;
  Vec3Lanes outgoing;

  EightSurfaces(double roughness, Pcg32& random) : materials(fast_path_materials(roughness)) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      outgoing.put(lane, uniform_hemisphere(random));
    }
  }
  FastPathBsdfs bsdfs() const {
    FastPathLayersLanes layers;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      layers.put(lane, fast_path_layers(reflectance_of(materials[lane])));
    }
    return {layers, outgoing.load(), scattering_tables().ggx()};
  }
};

Vec3 direction_at(const Vec3s& directions, std::size_t lane) {
  return {directions.x[lane], directions.y[lane], directions.z[lane]};
}

TEST(FastPathBsdfTest, ValuesAreTheModelsFormula) {
  Pcg32 random(1);
  for (const double roughness : {0.1, 0.4, 1.0}) {
    std::vector<ReferenceCoat> coats;
    for (const ReferenceMaterial& material : fast_path_materials(roughness)) {
      coats.emplace_back(material);
    }
    for (int i = 0; i < 20; ++i) {
      const EightSurfaces surfaces(roughness, random);
      Vec3Lanes incoming;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        incoming.put(lane, uniform_hemisphere(random));
      }
      const FastPathBsdfs::Values values = surfaces.bsdfs().eval(incoming.load());
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const DVec3 o(surfaces.outgoing.at(lane));
        const DVec3 in(incoming.at(lane));
        const double expected =
            in.z * reference_bsdf(surfaces.materials[lane], coats[lane], o, in, 1.0);
        const double exactness = std::min(o.z, in.z) < 0.05 ? 0.01 : 0.003;
        EXPECT_NEAR(values.times_cosine.y[lane], expected, exactness * expected + 1e-7)
            << lane << ' ' << roughness << ' ' << o.z << ' ' << in.z;
      }
    }
  }
}

TEST(FastPathBsdfTest, NothingComesFromBelow) {
  Pcg32 random(2);
  const EightSurfaces surfaces(0.3, random);
  const FastPathBsdfs::Values values = surfaces.bsdfs().eval(all_lanes(Vec3(0.6F, 0.0F, -0.8F)));
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_EQ(max_component(values.times_cosine)[lane], 0.0F);
    EXPECT_EQ(values.pdf[lane], 0.0F);
  }
}

// Those of Bsdf are held against their density by chi-squared tests.
TEST(FastPathBsdfTest, SamplesAreThoseOfBsdf) {
  Pcg32 random(3);
  for (const double roughness : {0.1, 0.4, 1.0}) {
    for (int i = 0; i < 200; ++i) {
      const EightSurfaces surfaces(roughness, random);
      FloatLanes u_lobe;
      Vec2Lanes u;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        u_lobe[lane] = unit_float(random.next());
        const Vec2 point = unit_square(random);
        u.x[lane] = point.x;
        u.y[lane] = point.y;
      }
      const auto samples = surfaces.bsdfs().sample(u_lobe.load(), u.load());
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const auto expected = Bsdf(reflectance_of(surfaces.materials[lane]),
                                   surfaces.outgoing.at(lane), scattering_tables())
                                  .sample(u_lobe[lane], u.at(lane));
        if (!expected) {
          EXPECT_TRUE(samples.pdf[lane] == 0.0F || samples.incoming.z[lane] <= 0.0F);
          continue;
        }
        EXPECT_LT(glm::length(direction_at(samples.incoming, lane) - expected->incoming), 1e-5F);
        EXPECT_NEAR(samples.pdf[lane], expected->pdf, 1e-3F * expected->pdf);
        EXPECT_NEAR(samples.weight.y[lane], expected->weight.y, 1e-4F * expected->weight.y + 1e-6F);
      }
    }
  }
}

TEST(FastPathBsdfTest, MeanWeightIsTheQuadraturesAlbedo) {
  Pcg32 random(4);
  const EightSurfaces surfaces(0.5, random);
  const FastPathBsdfs bsdfs = surfaces.bsdfs();
  std::array<MeanEstimate, lane_count> means;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    SampleStream stream(7, 0, i);
    const float u_lobe = stream.next_1d();
    const Vec2 u = stream.next_2d();
    const auto samples = bsdfs.sample(all_lanes(u_lobe), {all_lanes(u.x), all_lanes(u.y)});
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const bool is_found = samples.pdf[lane] > 0.0F && samples.incoming.z[lane] > 0.0F;
      means[lane].add(is_found ? samples.weight.y[lane] : 0.0F);
    }
  }
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const double cosine = surfaces.outgoing.z[lane];
    expect_mean(means[lane], reference_albedo(surfaces.materials[lane], cosine), 1e-3);
  }
}

TEST(FastPathBsdfTest, CoversTransmissionAndSmoothnessTakeTheGeneralPath) {
  EXPECT_TRUE(is_on_fast_path(Reflectance{}));
  EXPECT_FALSE(is_on_fast_path(Reflectance{.transmission = 0.1F}));
  EXPECT_FALSE(is_on_fast_path(Reflectance{.clearcoat = 0.1F}));
  EXPECT_FALSE(is_on_fast_path(Reflectance{.sheen_color = Rgb(0.0F, 0.1F, 0.0F)}));
  EXPECT_TRUE(is_on_fast_path(fast_path_layers({.roughness = 0.11F})));
  EXPECT_FALSE(is_on_fast_path(fast_path_layers({.roughness = 0.09F})));
  EXPECT_TRUE(is_on_fast_path(fast_path_layers({.roughness = 0.0F, .specular = 0.0F})));
}

}  // namespace
}  // namespace foveola
