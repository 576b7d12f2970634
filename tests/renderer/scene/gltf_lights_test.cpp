#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// One triangle, and `light` at a node with `transform`.
GlbBuilder lit(const Json& light, Json transform = Json::object()) {
  GlbBuilder glb = one_triangle();
  glb.document["extensionsUsed"] = {"KHR_lights_punctual"};
  glb.document["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
  transform["extensions"]["KHR_lights_punctual"]["light"] = 0;
  glb.add_root(transform);
  return glb;
}

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-6F);
  EXPECT_NEAR(actual.y, expected.y, 1e-6F);
  EXPECT_NEAR(actual.z, expected.z, 1e-6F);
}

using GltfLights = LoadGltf;

/// The extension's table of defaults.
TEST_F(GltfLights, AbsentPropertiesAreTheExtensions) {
  const Scene scene = load(lit({{"type", "spot"}, {"spot", Json::object()}}));
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].intensity, Rgb(1.0F));
  EXPECT_EQ(scene.lights[0].inner_cone_rad, 0.0F);
  EXPECT_FLOAT_EQ(scene.lights[0].outer_cone_rad, std::numbers::pi_v<float> / 4.0F);
  expect_near(scene.lights[0].direction, {0, 0, -1});
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(GltfLights, APointHasAPositionAndAnIntensity) {
  const Scene scene =
      load(lit({{"type", "point"}, {"name", "bulb"}, {"color", {1, 0.5, 0.25}}, {"intensity", 8}},
               {{"translation", {1, 2, 3}}, {"scale", {10, 10, 10}}}));
  const PunctualLight& light = scene.lights.at(0);
  EXPECT_EQ(light.kind, PunctualLight::Kind::point);
  EXPECT_EQ(light.name, "bulb");
  EXPECT_EQ(light.intensity, Rgb(8, 4, 2)) << "scale does not change it";
  expect_near(light.position, {1, 2, 3});
  EXPECT_EQ(light.radius_m, 0.0F);
}

/// A quarter turn about +X turns -Z to -Y... by the right-hand rule: y' = -z, so (0, 0, -1) goes to
/// (0, 1, 0); a turn the other way points it down.
TEST_F(GltfLights, ADirectionalLightShinesAlongItsNodesMinusZ) {
  const Scene scene =
      load(lit({{"type", "directional"}, {"intensity", 3}},
               {{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}, {"scale", {1, 1, 5}}}));
  const PunctualLight& light = scene.lights.at(0);
  EXPECT_EQ(light.kind, PunctualLight::Kind::directional);
  expect_near(light.direction, {0, -1, 0});
  EXPECT_EQ(light.intensity, Rgb(3.0F));
}

TEST_F(GltfLights, ASpotHasACone) {
  const Scene scene =
      load(lit({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
               {{"translation", {0, 4, 0}}, {"scale", {3, 3, 3}}}));
  const PunctualLight& light = scene.lights.at(0);
  EXPECT_EQ(light.kind, PunctualLight::Kind::spot);
  EXPECT_EQ(light.inner_cone_rad, 0.25F);
  EXPECT_EQ(light.outer_cone_rad, 0.5F);
  expect_near(light.position, {0, 4, 0});
}

/// 0 <= inner < outer <= pi / 2.
TEST_F(GltfLights, ConesAreLimitedWithAWarning) {
  const Scene scene =
      load(lit({{"type", "spot"}, {"spot", {{"innerConeAngle", 3.0}, {"outerConeAngle", 2.0}}}}));
  const PunctualLight& light = scene.lights.at(0);
  EXPECT_FLOAT_EQ(light.outer_cone_rad, std::numbers::pi_v<float> / 2.0F);
  EXPECT_LE(light.inner_cone_rad, light.outer_cone_rad);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the cone of a spot light is limited")));
}

TEST_F(GltfLights, ARoundedRightAngleIsNoReasonToWarn) {
  EXPECT_THAT(load(lit({{"type", "spot"}, {"spot", {{"outerConeAngle", 1.570797}}}})).warnings,
              IsEmpty());
}

TEST_F(GltfLights, ARangeIsIgnoredWithAWarning) {
  const Scene scene = load(lit({{"type", "point"}, {"range", 5}}));
  EXPECT_EQ(scene.lights.size(), 1U);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the range of a light is ignored")));
}

TEST_F(GltfLights, IntensitiesAreLimitedWithAWarning) {
  const Scene scene = load(lit({{"type", "point"}, {"color", {1, -1, 1}}, {"intensity", 2}}));
  EXPECT_EQ(scene.lights.at(0).intensity, Rgb(2, 0, 2));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the intensity of a light is limited")));
}

TEST_F(GltfLights, DarkLightsAreLeftOut) {
  EXPECT_THAT(load(lit({{"type", "point"}, {"intensity", 0}})).lights, IsEmpty());
}

TEST_F(GltfLights, OneWithoutADirectionIsLeftOut) {
  const Scene scene = load(lit({{"type", "directional"}}, {{"scale", {0, 0, 0}}}));
  EXPECT_THAT(scene.lights, IsEmpty());
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no direction is left out (nodes[1])")));
}

TEST_F(GltfLights, EveryNodeHasALightOfItsOwn) {
  GlbBuilder glb = lit({{"type", "point"}});
  glb.add_root({{"name", "second"},
                {"translation", {5, 0, 0}},
                {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[1].name, "second");
  expect_near(scene.lights[1].position, {5, 0, 0});
}

}  // namespace
}  // namespace foveola::test
