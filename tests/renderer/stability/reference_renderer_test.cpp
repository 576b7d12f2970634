// Two renderers that share no transport must agree on every block of a picture.
#include "reference_renderer.h"

#include <gtest/gtest.h>

#include "renderer/stability/closed_forms.h"
#include "renderer/stability/estimate.h"
#include "worlds.h"

namespace foveola::reference {
namespace {

/// What tessellated spheres may change: 82000 triangles miss 0.02 % of a sphere's area.
constexpr double tessellation = 1e-3;

double largest_relative_error(const std::vector<RadianceEstimate>& picture) {
  double largest = 0.0;
  for (const RadianceEstimate& block : picture) {
    for (int channel = 0; channel < 3; ++channel) {
      largest = std::max(largest, block.standard_error[channel] / block.mean[channel]);
    }
  }
  return largest;
}

struct Case {
  const char* name;
  World (*world)();
  DVec3 viewpoint;
  int max_depth;
};

class ReferenceRendererTest : public ::testing::TestWithParam<Case> {};

TEST_P(ReferenceRendererTest, BlocksOfBothPicturesAgree) {
  const Workers workers;
  const World world = GetParam().world();
  const auto expected = render(world, GetParam().viewpoint, 4, 2048, GetParam().max_depth, workers);
  const Scene scene = scene_of(world);
  const StabilityRun run{.workers = workers, .effort = {.picture_samples_per_pixel = 128}};
  const auto picture = render_blocks(PathTracer(scene, workers), Vec3(GetParam().viewpoint),
                                     {.block = 16, .max_depth = GetParam().max_depth}, run);
  const StabilityFigure figure =
      picture_difference(GetParam().name, picture, expected, tessellation);
  EXPECT_TRUE(figure.passes()) << figure.measured << " standard errors; " << figure.details;
  // So that a difference of a few percent would show.
  EXPECT_LT(largest_relative_error(expected), 0.02);
  EXPECT_LT(largest_relative_error(picture), 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, ReferenceRendererTest,
    ::testing::Values(Case{"balls", balls_under_sky, DVec3(0.1, 0.7, 0.2), 5},
                      Case{"balls_direct", balls_under_sky, DVec3(0.1, 0.7, 0.2), 1},
                      Case{"room", lit_room, DVec3(0.1, 0.2, 0.3), 5},
                      Case{"mirrors", hall_of_mirrors, DVec3(0.1, 0.3, 0.2), 6}),
    [](const auto& tested) { return tested.param.name; });

// The oracle itself, against closed forms.

double mean_radiance(const World& world, const DVec3& origin, const DVec3& direction, int max_depth,
                     int samples) {
  Pcg32 random(1);
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    sum += radiance(world, origin, glm::normalize(direction), max_depth, random).g;
  }
  return sum / samples;
}

TEST(ReferenceRendererTest, FurnaceIsTheGeometricSeries) {
  World world{.surfaces = {{.color = DVec3(0.5), .emission = DVec3(0.5)}}};
  add_box(world, DVec3(-1.0), DVec3(1.0), 0, true);
  for (const int depth : {0, 1, 5}) {
    EXPECT_NEAR(mean_radiance(world, DVec3(0.1), DVec3(1, 2, 3), depth, 10),
                1.0 - std::pow(0.5, depth + 1), 1e-12);
  }
}

TEST(ReferenceRendererTest, RectangleLightsAFloorByItsFormFactor) {
  World world{.surfaces = palette()};
  world.panels = {{DVec3(-5, 0, 5), DVec3(10, 0, 0), DVec3(0, 0, -10), grey},
                  {DVec3(0, 1, 0), DVec3(1, 0, 0), DVec3(0, 0, 2), bright}};
  const double expected = 0.7 * 3.5 * corner_rectangle_form_factor(1.0, 2.0, 1.0);
  EXPECT_NEAR(mean_radiance(world, DVec3(-1, 1, 0), DVec3(1, -1, 0), 1, 400000), expected,
              5.0 * std::sqrt(0.7 * 3.5 * expected / 400000));
}

TEST(ReferenceRendererTest, GlassSlabIsTheStokesSeries) {
  World world{.surfaces = palette()};
  world.surfaces[bright].color = DVec3(0.0);
  add_box(world, DVec3(-9, -0.5, -9), DVec3(9, 0, 9), clear, false);
  world.panels.push_back({DVec3(-9, -1, 9), DVec3(18, 0, 0), DVec3(0, 0, -18), bright});
  const double shares = slab_shares({.thickness_m = 0.5}, 0.6).transmitted;
  EXPECT_NEAR(mean_radiance(world, DVec3(0, 1, 0), DVec3(0.8, -0.6, 0), 30, 100000), 3.5 * shares,
              5.0 * 3.5 * std::sqrt(shares * (1.0 - shares) / 100000));
}

TEST(ReferenceRendererTest, MirrorReflectsAsSchlickSays) {
  World world{.surfaces = palette(), .environment = DVec3(1.0)};
  world.panels = {{DVec3(-5, 0, 5), DVec3(10, 0, 0), DVec3(0, 0, -10), mirror}};
  EXPECT_NEAR(mean_radiance(world, DVec3(0, 1, 0), DVec3(0.8, -0.6, 0), 1, 1),
              0.7 + 0.3 * std::pow(0.4, 5.0), 1e-12);
}

}  // namespace
}  // namespace foveola::reference
