#include "renderer/scene/gltf/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "renderer/scene/load_scene.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::FloatEq;

/// One triangle, and `light` at a node with `transform`.
GlbBuilder lit(const Json& light, const Json& transform = Json::object()) {
  GlbBuilder glb = one_triangle();
  glb.document["extensionsUsed"] = {"KHR_lights_punctual"};
  glb.add_light(light, transform);
  return glb;
}

using GltfLights = LoadGltf;

std::filesystem::path blender_export(const std::string& mode) {
  return std::filesystem::path(TEST_DATA_DIR) / "blender" / (mode + ".gltf");
}

/// The irradiance of the sun, and the radiant intensities of the point and the spot.
std::vector<float> intensities(const Scene& scene) {
  std::vector<float> result;
  for (const PunctualLight& light : scene.lights) {
    EXPECT_EQ(light.intensity, Rgb(light.intensity.r)) << "white in Blender";
    result.push_back(light.intensity.r);
  }
  return result;
}

/// The emission of the panel in Blender's exports.
Rgb emission(const Scene& scene) {
  const auto shines = [](const Material& material) { return material.is_emissive(); };
  return std::find_if(scene.materials.begin(), scene.materials.end(), shines)->emission;
}

/// The extension's table of defaults.
TEST_F(GltfLights, AbsentPropertiesAreTheExtensions) {
  const Scene scene = load(lit({{"type", "spot"}, {"spot", Json::object()}}));
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].intensity, Rgb(1.0F));
  EXPECT_EQ(scene.lights[0].inner_cone_rad, 0.0F);
  EXPECT_FLOAT_EQ(scene.lights[0].outer_cone_rad, std::numbers::pi_v<float> / 4.0F);
  expect_vec_near(scene.lights[0].direction, {0, 0, -1});
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
  expect_vec_near(light.position, {1, 2, 3});
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
  expect_vec_near(light.direction, {0, -1, 0});
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
  expect_vec_near(light.position, {0, 4, 0});
}

/// tests/data/blender/README.md: a sun of 2 W/m^2, lights of 4 pi W, and an emission of 3.
TEST_F(GltfLights, OfBlendersExportsFitTheirEmission) {
  const Scene standard = load_gltf(blender_export("standard"));
  EXPECT_THAT(intensities(standard), ElementsAre(FloatEq(2), FloatEq(1), FloatEq(1)));
  EXPECT_EQ(emission(standard), Rgb(3, 1.5, 0.75));
  EXPECT_THAT(standard.warnings,
              ElementsAre(AllOf(HasSubstr("683 lm/W"), HasSubstr("--light-units radiometric"))));

  const Scene unitless = load_gltf(blender_export("unitless"), {LightUnits::radiometric});
  EXPECT_THAT(intensities(unitless), ElementsAre(FloatEq(2), FloatEq(1), FloatEq(1)));
  EXPECT_EQ(emission(unitless), Rgb(3, 1.5, 0.75));
  EXPECT_THAT(unitless.warnings, IsEmpty());

  constexpr float all_around = 4.0F * std::numbers::pi_v<float>;
  const Scene raw = load_gltf(blender_export("raw"), {LightUnits::radiometric});
  EXPECT_THAT(intensities(raw), ElementsAre(FloatEq(2), FloatEq(all_around), FloatEq(all_around)));
}

TEST_F(GltfLights, AreInTheUnitsThatWereSaid) {
  EXPECT_THAT(intensities(load_gltf(blender_export("standard"), {LightUnits::radiometric})),
              ElementsAre(FloatEq(1366), FloatEq(683), FloatEq(683)));
  const Scene said = load_gltf(blender_export("standard"), {LightUnits::photometric});
  EXPECT_THAT(intensities(said), ElementsAre(FloatEq(2), FloatEq(1), FloatEq(1)));
  EXPECT_THAT(said.warnings, IsEmpty()) << "who said it knows it";
  const auto from_elsewhere = lit({{"type", "point"}, {"intensity", 1366}});
  EXPECT_THAT(intensities(load(from_elsewhere)), ElementsAre(FloatEq(1366)));
  SceneSource source;
  source.file = write("lit.glb", from_elsewhere.bytes());
  source.light_units = LightUnits::photometric;
  EXPECT_THAT(intensities(load_scene(source)), ElementsAre(FloatEq(2)));
}

/// The exporter's history: lights in lux and candela were merged after 3.4.39.
TEST(GltfLightUnits, AreTheGenerators) {
  for (const char* generator :
       {"Khronos glTF Blender I/O v3.4.40", "Khronos glTF Blender I/O v3.4.50",
        "Khronos glTF Blender I/O v3.6.28", "Khronos glTF Blender I/O v4.0.44",
        "Khronos glTF Blender I/O v10.0.0-beta"}) {
    EXPECT_EQ(light_units_of(generator), LightUnits::photometric) << generator;
  }
  for (const char* generator :
       {"", "Foveola", "Khronos glTF Blender I/O v3.4.39", "Khronos glTF Blender I/O v3.3.36",
        "Khronos glTF Blender I/O v1.8.19", "Khronos glTF Blender I/O v",
        "Khronos glTF Blender I/O v4", "Khronos glTF Blender I/O v99999999999.0.0",
        "Khronos Blender glTF 2.0 exporter", "glTF-Transform v3.4.50"}) {
    EXPECT_EQ(light_units_of(generator), LightUnits::radiometric) << generator;
  }
}

/// Blender's default spot: 45 degrees wide, a blend of 0.15.
TEST_F(GltfLights, OfBlendersExportsHaveTheConesOfCycles) {
  const Scene scene = load_gltf(blender_export("standard"));
  const PunctualLight& light = scene.lights.at(2);
  ASSERT_EQ(light.kind, PunctualLight::Kind::spot);
  EXPECT_EQ(light.cone_edge, PunctualLight::ConeEdge::smooth_times_cosine);
  const double outer = std::numbers::pi / 8.0;
  EXPECT_NEAR(light.outer_cone_rad, outer, 1e-6);
  EXPECT_NEAR(std::cos(light.inner_cone_rad) - std::cos(outer), 0.15 * (1.0 - std::cos(outer)),
              1e-6);
}

TEST_F(GltfLights, ConesOfOtherFilesAreTheExtensions) {
  const auto spot = lit({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}}}});
  EXPECT_EQ(load(spot).lights.at(0).cone_edge, PunctualLight::ConeEdge::squared);
}

TEST(GltfConeEdges, AreTheGenerators) {
  using Edge = PunctualLight::ConeEdge;
  EXPECT_EQ(cone_edge_of("Khronos glTF Blender I/O v3.3.36"), Edge::smooth_times_cosine);
  EXPECT_EQ(cone_edge_of("Khronos glTF Blender I/O v4.0.44"), Edge::smooth);
  EXPECT_EQ(cone_edge_of("Khronos glTF Blender I/O"), Edge::squared);
  EXPECT_EQ(cone_edge_of(""), Edge::squared);
}

TEST(GltfConeEdges, CyclesFadesOverAShareOfTheCone) {
  EXPECT_NEAR(cycles_inner_cone_rad(0.0, 0.6), 0.0, 1e-7) << "a blend of 1";
  EXPECT_NEAR(cycles_inner_cone_rad(0.6, 0.6), 0.6, 1e-12) << "a blend of 0";
  EXPECT_NEAR(std::cos(cycles_inner_cone_rad(0.3, 0.6)), 0.5 * (std::cos(0.6) + 1.0), 1e-12);
}

TEST_F(GltfLights, OfAFileWithoutLightsNothingIsSaid) {
  GlbBuilder glb = one_triangle();
  glb.document["asset"]["generator"] = "Khronos glTF Blender I/O v4.2.60";
  EXPECT_THAT(load(glb).warnings, IsEmpty());
}

/// 0 <= inner < outer <= pi / 2.
TEST_F(GltfLights, ConesAreLimitedWithAWarning) {
  const Scene scene =
      load(lit({{"type", "spot"}, {"spot", {{"innerConeAngle", 3.0}, {"outerConeAngle", 2.0}}}}));
  const PunctualLight& light = scene.lights.at(0);
  EXPECT_FLOAT_EQ(light.outer_cone_rad, std::numbers::pi_v<float> / 2.0F);
  EXPECT_LE(light.inner_cone_rad, light.outer_cone_rad);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the cone of a spot light is clamped")));
}

TEST_F(GltfLights, WhatIsLeftOutOrIgnoredIsWarnedOf) {
  const Json none = Json::object();
  for (const auto& [light, transform, lights, warning] :
       std::vector<std::tuple<Json, Json, std::size_t, std::string>>{
           {{{"type", "area"}}, none, 0, "lights of type \"area\" are left out (lights[0])"},
           {{{"type", "point"}, {"range", 5}}, none, 1, "the range of a light is ignored"},
           {{{"type", "directional"}},
            {{"scale", {0, 0, 0}}},
            0,
            "no direction is left out (nodes[1])"},
           {{{"type", "point"}, {"intensity", 0}}, none, 0, ""},
           // A rounded right angle is no reason to warn.
           {{{"type", "spot"}, {"spot", {{"outerConeAngle", 1.570797}}}}, none, 1, ""}}) {
    const Scene scene = load(lit(light, transform));
    EXPECT_THAT(scene.lights, SizeIs(lights)) << light;
    EXPECT_THAT(scene.warnings, SizeIs(warning.empty() ? 0 : 1)) << light;
    EXPECT_THAT(scene.warnings, Each(HasSubstr(warning)));
  }
}

TEST_F(GltfLights, IntensitiesAreLimitedWithAWarning) {
  const Scene scene = load(lit({{"type", "point"}, {"color", {1, -1, 1}}, {"intensity", 2}}));
  EXPECT_EQ(scene.lights.at(0).intensity, Rgb(2, 0, 2));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the intensity of a light is clamped")));
}

Json with_own_extras(Json light, const Json& own) {
  light["extras"]["foveola"] = own;
  return light;
}

TEST_F(GltfLights, HaveTheSizesOfTheirExtras) {
  const Json bulb = with_own_extras({{"type", "point"}}, {{"radius_m", 0.25}});
  EXPECT_EQ(load(lit(bulb)).lights.at(0).radius_m, 0.25F);
  const Json spot =
      with_own_extras({{"type", "spot"}, {"spot", Json::object()}}, {{"radius_m", 2}});
  EXPECT_EQ(load(lit(spot)).lights.at(0).radius_m, 2.0F) << "written as a whole number";
  const Scene scene =
      load(lit(with_own_extras({{"type", "directional"}}, {{"angular_radius_rad", 0.125}})));
  EXPECT_EQ(scene.lights.at(0).angular_radius_rad, 0.125F);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

/// A directional light has no radius in metres, and other programs have extras of their own.
TEST_F(GltfLights, HaveNoSizesByOtherExtras) {
  const Scene sun = load(lit(with_own_extras({{"type", "directional"}}, {{"radius_m", 0.25}})));
  EXPECT_EQ(sun.lights.at(0).angular_radius_rad, 0.0F);
  EXPECT_EQ(sun.lights.at(0).radius_m, 0.0F);
  for (const Json& extras : {Json("words"), Json{{"radius_m", 1}}, Json{{"foveola", 7}},
                             Json{{"foveola", {{"wattage", 60}}}}, Json()}) {
    const Scene scene = load(lit({{"type", "point"}, {"extras", extras}}));
    EXPECT_EQ(scene.lights.at(0).radius_m, 0.0F) << extras;
    EXPECT_THAT(scene.warnings, IsEmpty()) << extras;
  }
}

TEST_F(GltfLights, SizesAreLimitedWithAWarning) {
  const auto says_so = ElementsAre(HasSubstr("the size of a light is clamped"));
  for (const Json& wrong : {Json(-1), Json("wide"), Json::array({1})}) {
    const Scene scene = load(lit(with_own_extras({{"type", "point"}}, {{"radius_m", wrong}})));
    EXPECT_EQ(scene.lights.at(0).radius_m, 0.0F) << wrong;
    EXPECT_THAT(scene.warnings, says_so) << wrong;
  }
  const Scene wide =
      load(lit(with_own_extras({{"type", "directional"}}, {{"angular_radius_rad", 1.5}})));
  EXPECT_FLOAT_EQ(wide.lights.at(0).angular_radius_rad, std::numbers::pi_v<float> / 4.0F);
  EXPECT_THAT(wide.warnings, says_so);
}

/// What a descriptor or the command line says of all lights counts for more.
TEST_F(GltfLights, ASizeThatWasSaidReplacesThoseOfTheExtras) {
  SceneSource source;
  source.file =
      write("lit.glb", lit(with_own_extras({{"type", "point"}}, {{"radius_m", 0.25}})).bytes());
  source.metres_per_unit = 2.0;
  EXPECT_EQ(load_scene(source).lights.at(0).radius_m, 0.5F) << "in the file's units";
  source.light_radius_m = 0.0F;
  EXPECT_EQ(load_scene(source).lights.at(0).radius_m, 0.0F);
}

TEST_F(GltfLights, EveryNodeHasALightOfItsOwn) {
  GlbBuilder glb = lit({{"type", "point"}});
  glb.add_root({{"name", "second"},
                {"translation", {5, 0, 0}},
                {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[1].name, "second");
  expect_vec_near(scene.lights[1].position, {5, 0, 0});
}

}  // namespace
}  // namespace foveola::test
