#include "renderer/trace/lights/light_tree.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using test::in_cube;
using test::random_shading_point;

constexpr double right_angle = 0.5 * std::numbers::pi;

/// A flat light of the given half size at `centre`, with two of its points.
struct FlatLight {
  Vec3 centre;
  Vec3 reach;
  Vec3 normal;
  bool two_sided;

  FlatLight(Pcg32& random, float size)
      : centre(in_cube(random)), normal(glm::normalize(in_cube(random))) {
    reach = size * glm::normalize(glm::cross(normal, in_cube(random)));
    two_sided = random.uniform() < 0.2;
  }

  LightBounds bounds(double intensity) const {
    return {.box = {.lower = centre - glm::abs(reach), .upper = centre + glm::abs(reach)},
            .axis = DVec3(normal),
            .spread_rad = 0.0,
            .falloff_rad = right_angle,
            .two_sided = two_sided,
            .intensity = intensity};
  }

  /// Whether a point of it is in front of the shading point and shines towards it.
  bool reaches(const ShadingPoint& shading_point) const {
    for (const float t : {-1.0F, 0.0F, 1.0F}) {
      const Vec3 to_light = centre + t * reach - shading_point.position;
      const float emission = -glm::dot(normal, to_light);
      const float incidence = glm::dot(shading_point.normal, to_light);
      if ((two_sided || emission > 0.0F) && (shading_point.transmits || incidence > 0.0F)) {
        return true;
      }
    }
    return false;
  }
};

struct FlatLights {
  std::vector<FlatLight> lights;
  std::vector<LightBounds> bounds;

  FlatLights(int count, float size, std::uint64_t seed) {
    Pcg32 random(seed);
    for (int i = 0; i < count; ++i) {
      lights.emplace_back(random, size);
      bounds.push_back(lights.back().bounds(std::exp(2.0 * random.normal())));
    }
  }
};

/// Draws lights for some places: as often as their probability says, whose sum is at most 1.
void expect_drawn_by_probability(const LightTree& tree, std::size_t count,
                                 const LightTree::Preferences* preferences) {
  constexpr int draws = 50000;
  constexpr int shading_points = 8;
  Pcg32 random(2);
  for (int r = 0; r < shading_points; ++r) {
    const ShadingPoint shading_point = random_shading_point(random, 3.0F);
    std::vector<double> observed(count + 1, 0.0);
    std::vector<double> expected(count + 1, 0.0);
    for (int i = 0; i < draws; ++i) {
      const auto chosen = tree.sample(shading_point, random.uniform(), preferences);
      observed[chosen ? chosen->light : count] += 1.0;
      if (chosen) {
        ASSERT_FLOAT_EQ(chosen->probability,
                        tree.probability(shading_point, chosen->light, preferences));
      }
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double probability = tree.probability(shading_point, i, preferences);
      expected[i] = probability * draws;
      sum += probability;
    }
    EXPECT_LE(sum, 1.0 + 1e-5);
    expected[count] = std::max(0.0, 1.0 - sum) * draws;
    EXPECT_GT(chi_squared_p_value(observed, expected), sidak_level(shading_points));
  }
}

TEST(LightTreeTest, LightsAreDrawnWithTheirProbability) {
  constexpr int count = 200;
  const LightTree tree(FlatLights(count, 0.05F, 1).bounds);
  expect_drawn_by_probability(tree, count, nullptr);
}

TEST(LightTreeTest, LightsAreDrawnWithTheirProbabilityWhereSomeArePreferred) {
  constexpr int count = 200;
  const LightTree tree(FlatLights(count, 0.05F, 1).bounds);
  LightTree::Preferences preferences;
  Pcg32 random(3);
  for (LightTree::Lanes& node : preferences) {
    for (float& preference : node) {
      preference = static_cast<float>(std::exp(random.normal()));
    }
  }
  expect_drawn_by_probability(tree, count, &preferences);
}

/// The children of the root are told apart by which of its preferences lights follow.
TEST(LightTreeTest, WhatIsPreferredIsDrawnMoreOften) {
  constexpr std::size_t count = 200;
  const LightTree tree(FlatLights(count, 0.05F, 1).bounds);
  LightTree::Preferences preferences;
  for (LightTree::Lanes& node : preferences) {
    node.fill(1.0F);
  }
  preferences[0][2] = 10.0F;
  const ShadingPoint far_away{.position = Vec3(0, 40, 0)};
  for (std::size_t light = 0; light < count; ++light) {
    std::size_t child_of_root = 0;
    tree.for_each_preference(light, [&](std::size_t node, std::size_t child) {
      child_of_root = node == 0 ? child : child_of_root;
    });
    const float usual = tree.probability(far_away, light);
    const float preferred = tree.probability(far_away, light, &preferences);
    if (usual > 0.0F) {
      EXPECT_EQ(preferred > usual, child_of_root == 2) << light;
    }
  }
}

TEST(LightTreeTest, NoLightThatReachesTheShadingPointIsForgotten) {
  int reached = 0;
  int drawable = 0;
  for (const float size : {0.0F, 0.02F, 0.7F}) {
    const FlatLights flat(300, size, 3);
    const LightTree tree(flat.bounds);
    Pcg32 random(4);
    for (int r = 0; r < 100; ++r) {
      const ShadingPoint shading_point = random_shading_point(random, r % 2 == 0 ? 1.0F : 4.0F);
      for (std::size_t i = 0; i < flat.lights.size(); ++i) {
        const float probability = tree.probability(shading_point, i);
        drawable += probability > 0.0F ? 1 : 0;
        if (flat.lights[i].reaches(shading_point)) {
          ++reached;
          ASSERT_GT(probability, 0.0F) << i;
        }
      }
    }
  }
  // And of those that do not, most are.
  EXPECT_LT(drawable, 1.5 * reached);
}

TEST(LightTreeTest, PrefersTheNearOfEqualLights) {
  std::vector<LightBounds> bounds;
  for (int i = 0; i < 64; ++i) {
    const Vec3 position(static_cast<float>(i), 0, 0);
    bounds.push_back({.box = {.lower = position, .upper = position},
                      .axis = {0, -1, 0},
                      .falloff_rad = right_angle,
                      .intensity = 1.0});
  }
  const LightTree tree(bounds);
  const ShadingPoint below{.position = Vec3(20, -1, 0)};
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_LE(tree.probability(below, i), tree.probability(below, 20));
  }
  EXPECT_GT(tree.probability(below, 20), 0.2F);
}

TEST(LightTreeTest, LightsBehindTheShadingPointOrTurnedAwayAreNotDrawn) {
  const LightBounds down{.box = {.lower = Vec3(-1, 2, -1), .upper = Vec3(1, 2, 1)},
                         .axis = {0, -1, 0},
                         .falloff_rad = right_angle,
                         .intensity = 1.0};
  const LightTree tree(std::vector<LightBounds>(3, down));
  EXPECT_TRUE(
      tree.sample({.position = Vec3(0, -5, 0), .normal = {0, 1, 0}, .transmits = false}, 0.5));
  EXPECT_FALSE(
      tree.sample({.position = Vec3(0, -5, 0), .normal = {0, -1, 0}, .transmits = false}, 0.5));
  EXPECT_TRUE(
      tree.sample({.position = Vec3(0, -5, 0), .normal = {0, -1, 0}, .transmits = true}, 0.5));
  EXPECT_FALSE(tree.sample({.position = Vec3(0, 9, 0)}, 0.5));
}

TEST(LightTreeTest, LightsWithoutIntensityAreNeverDrawn) {
  FlatLights flat(40, 0.1F, 5);
  for (std::size_t i = 0; i < 40; i += 2) {
    flat.bounds[i].intensity = 0.0;
  }
  const LightTree tree(flat.bounds);
  Pcg32 random(6);
  for (int i = 0; i < 2000; ++i) {
    const ShadingPoint shading_point = random_shading_point(random, 2.0F);
    const auto chosen = tree.sample(shading_point, random.uniform());
    EXPECT_TRUE(!chosen || chosen->light % 2 == 1);
    EXPECT_EQ(tree.probability(shading_point, 8), 0.0F);
  }
}

/// Arrangements that a split by cost alone would turn into a list, or not split at all.
TEST(LightTreeTest, ChainsAndHeapsOfLightsAreFiniteAndDrawn) {
  std::vector<LightBounds> chain;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 position(static_cast<float>(std::pow(0.99, i)), 0, 0);
    chain.push_back({.box = {.lower = position, .upper = position},
                     .spread_rad = std::numbers::pi,
                     .falloff_rad = right_angle,
                     .intensity = std::pow(0.98, i)});
  }
  const std::vector<LightBounds> heap(1000, chain[0]);
  constexpr double largest = 1.0 - 0x1p-53;
  for (const auto& lights : {chain, heap}) {
    const LightTree tree(lights);
    for (const float x : {0.0F, 1e-20F, 1e-6F, 1.0F, 1e6F}) {
      const ShadingPoint shading_point{.position = Vec3(x, 0, 0)};
      for (const double u : {0.0, 0.3, largest}) {
        const auto chosen = tree.sample(shading_point, u);
        ASSERT_TRUE(chosen);
        EXPECT_GT(chosen->probability, 0.0F);
        EXPECT_LE(chosen->probability, 1.0F);
      }
      double sum = 0.0;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        sum += tree.probability(shading_point, i);
      }
      EXPECT_NEAR(sum, 1.0, 1e-5);
    }
  }
}

}  // namespace
}  // namespace foveola
