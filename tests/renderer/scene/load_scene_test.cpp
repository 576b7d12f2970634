#include "renderer/scene/load_scene.h"

#include <limits>

#include "renderer/base/error.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

class LoadScene : public InTemporaryFolder {
 protected:
  SceneSource source() const {
    SceneSource source;
    source.name = "room";
    source.file = write("room.glb", one_triangle().bytes());
    return source;
  }

  std::string error_with(const RectangleLight& light) const {
    SceneSource lit = source();
    lit.lights = {RectangleLight{}, light};
    return error_of([&] { load_scene(lit); });
  }
};

TEST_F(LoadScene, WithoutExtrasIsTheFile) {
  const Scene scene = load_scene(source());
  EXPECT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.sha256, load_gltf(source().file).sha256);
  EXPECT_FALSE(scene.environment.has_value());
}

// Embree takes numbers up to 1.844e18, the way from one end of the scene to the other too.
TEST_F(LoadScene, LeavesOutWhatStandsBeyondAllRays) {
  SceneSource far = source();
  far.file = write("far.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1e19 0\nv 0 0 8e17\n"
                   "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const Scene scene = load_scene(far);
  EXPECT_EQ(scene.triangle_count(), 2U);
  EXPECT_EQ(scene.bounds().upper, Vec3(1.0F, 1.0F, 8e17F));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("triangles beyond 9e+17 m")));

  GlbBuilder glb = one_triangle();
  for (const char* kind : {"point", "directional"}) {
    for (const double height : {8e17, 1e19}) {
      glb.add_light({{"type", kind}}, {{"translation", {0, height, 0}}});
    }
  }
  far.file = write("far.glb", glb.bytes());
  const Scene lit = load_scene(far);
  EXPECT_EQ(lit.lights.size(), 3U) << "directional lights stand nowhere";
  EXPECT_THAT(lit.warnings, ElementsAre(HasSubstr("lights beyond 9e+17 m")));
}

TEST_F(LoadScene, WarnsOfAnotherFileThanTheDescribedOne) {
  SceneSource described = source();
  described.title = "Hall";
  const std::string sha256_of_file = load_scene(described).sha256;
  described.described_sha256 = sha256_of_file;
  EXPECT_THAT(load_scene(described).warnings, IsEmpty());
  described.described_sha256.front() = sha256_of_file.front() == '0' ? '1' : '0';
  EXPECT_THAT(load_scene(described).warnings,
              ElementsAre(HasSubstr("room.glb is not the file that the descriptor "
                                    "of \"Hall\" means")));
}

TEST_F(LoadScene, AddsTheEnvironment) {
  SceneSource lit = source();
  lit.environment_radiance = Rgb(1, 2, 3);
  const Scene scene = load_scene(lit);
  ASSERT_TRUE(scene.environment.has_value());
  EXPECT_EQ(scene.environment->radiance, Rgb(1, 2, 3));
  EXPECT_TRUE(scene.environment->map.empty());
}

TEST_F(LoadScene, ChoosesTheLoaderByTheExtension) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(load_scene_file(write("room.obj", text)).triangle_count(), 1U);
  EXPECT_EQ(load_scene_file(write("ROOM.OBJ", text)).triangle_count(), 1U);
  EXPECT_EQ(load_scene_file(source().file).triangle_count(), 1U);
  EXPECT_THROW(load_scene_file(write("room.txt", text)), Error);
}

TEST_F(LoadScene, TurnsAndDimsTheEnvironment) {
  SceneSource lit = source();
  lit.environment_radiance = Rgb(1, 2, 3);
  lit.environment_strength = 0.5;
  lit.environment_rotation_rad = 1.25;
  const Scene scene = load_scene(lit);
  EXPECT_EQ(scene.environment->radiance, Rgb(0.5F, 1, 1.5F));
  EXPECT_EQ(scene.environment->rotation_rad, 1.25);
}

TEST_F(LoadScene, LoadsTheEnvironmentsImage) {
  SceneSource lit = source();
  lit.environment_file = write("sky.png", png(2, 1, 3, std::vector<std::uint8_t>(6, 255)));
  EXPECT_EQ(load_scene(lit).environment->map_width, 2);
}

/// The sky's rotation and strength are its sun's too.
TEST_F(LoadScene, AddsDaylightWithItsSun) {
  SceneSource lit = source();
  lit.sky = SunAndSky{.sun = {.azimuth_rad = 0.5, .elevation_rad = 0.5}};
  const Scene plain = load_scene(lit);
  ASSERT_EQ(plain.lights.size(), 1U);
  lit.environment_strength = 2.0;
  lit.environment_rotation_rad = 0.25;
  lit.sun_angular_radius_rad = 0.1F;
  const Scene turned = load_scene(lit);
  ASSERT_EQ(turned.lights.size(), 1U);
  EXPECT_NEAR(azimuth_elevation(-turned.lights[0].direction).azimuth_rad, 0.75, 1e-6);
  EXPECT_NEAR(azimuth_elevation(-turned.lights[0].direction).elevation_rad, 0.5, 1e-6);
  EXPECT_EQ(turned.lights[0].intensity, 2.0F * plain.lights[0].intensity);
  EXPECT_EQ(turned.lights[0].angular_radius_rad, 0.1F);
  EXPECT_EQ(turned.environment->radiance, Rgb(2.0F));
  lit.sky->sun.elevation_rad = -0.1;
  EXPECT_TRUE(load_scene(lit).lights.empty());
}

/// A sun of its own is as bright as it says, whatever the environment.
TEST_F(LoadScene, AddsSuns) {
  SceneSource lit = source();
  lit.suns = {{.place = {.azimuth_rad = -2.0, .elevation_rad = 0.7},
               .irradiance = {5.0F, 4.0F, 3.0F},
               .angular_radius_rad = 0.01}};
  lit.environment_strength = 2.0;
  const Scene scene = load_scene(lit);
  ASSERT_EQ(scene.lights.size(), 1U);
  const PunctualLight& sun = scene.lights[0];
  EXPECT_EQ(sun.kind, PunctualLight::Kind::directional);
  EXPECT_NEAR(azimuth_elevation(-sun.direction).azimuth_rad, -2.0, 1e-6);
  EXPECT_NEAR(azimuth_elevation(-sun.direction).elevation_rad, 0.7, 1e-6);
  EXPECT_EQ(sun.intensity, Rgb(5.0F, 4.0F, 3.0F));
  EXPECT_EQ(sun.angular_radius_rad, 0.01F);
}

TEST_F(LoadScene, RefusesEnvironmentsAndUnitsThatMakeNoSense) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](auto spoil) {
    SceneSource spoilt = source();
    spoil(spoilt);
    EXPECT_THROW(load_scene(spoilt), Error);
  };
  refuses([](SceneSource& s) { s.environment_strength = -1.0; });
  refuses([](SceneSource& s) { s.environment_strength = nan; });
  refuses([](SceneSource& s) { s.environment_strength = 1e39; });
  refuses([](SceneSource& s) {
    s.environment_radiance = Rgb(1e30F);
    s.environment_strength = 1e30;
  });
  refuses([](SceneSource& s) { s.environment_rotation_rad = nan; });
  refuses([](SceneSource& s) { s.light_radius_m = -1.0F; });
  refuses([](SceneSource& s) { s.sun_angular_radius_rad = -1.0F; });
  refuses([](SceneSource& s) { s.suns = {{.irradiance = Rgb(-1.0F)}}; });
  refuses([](SceneSource& s) { s.suns = {{.angular_radius_rad = nan}}; });
  refuses([](SceneSource& s) { s.sky = SunAndSky{.turbidity = 1.0}; });
  for (const double metres : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    refuses([&](SceneSource& s) { s.metres_per_unit = metres; });
  }
}

/// Area, place, extent and front of a light towards each of the six axes.
TEST_F(LoadScene, LightsAreRectanglesThatFaceTheirNormal) {
  struct Case {
    Vec3 normal;
    Vec3 extent;  ///< the extent of a light of size (2, 6)
  };
  const std::vector<Case> cases = {{{1, 0, 0}, {0, 2, 6}}, {{-1, 0, 0}, {0, 2, 6}},
                                   {{0, 1, 0}, {2, 0, 6}}, {{0, -1, 0}, {2, 0, 6}},
                                   {{0, 0, 1}, {2, 6, 0}}, {{0, 0, -1}, {2, 6, 0}}};
  for (const Case& c : cases) {
    SceneSource lit = source();
    lit.lights = {
        {.center = {10, 20, 30}, .size = {2, 6}, .normal = c.normal, .radiance = {5, 6, 7}}};
    const Scene scene = load_scene(lit);
    ASSERT_EQ(scene.meshes.size(), 2U);
    const Mesh& light = scene.meshes[1];
    const Material& material = scene.materials.at(static_cast<std::size_t>(light.material));
    EXPECT_EQ(material.emission, Rgb(5, 6, 7));
    EXPECT_FALSE(material.double_sided);
    EXPECT_EQ(material.base_color, Rgb(0.0F));
    Scene alone;
    alone.meshes = {light};
    EXPECT_EQ(alone.bounds().lower, Vec3(10, 20, 30) - 0.5F * c.extent);
    EXPECT_EQ(alone.bounds().upper, Vec3(10, 20, 30) + 0.5F * c.extent);
    Vec3 area(0.0F);
    for (const auto& triangle : light.triangles) {
      const Vec3 a = light.positions[triangle[0]];
      area += 0.5F * glm::cross(light.positions[triangle[1]] - a, light.positions[triangle[2]] - a);
    }
    EXPECT_EQ(area, 12.0F * c.normal);
  }
}

/// A solid triangle with a camera, a lamp and a sun, all of them 4096 units away.
GlbBuilder far_and_lit() {
  GlbBuilder glb = one_triangle();
  const auto at = [](double x) { return Json{{"translation", {4096.0 + x, 0, 0}}}; };
  glb.document["nodes"][0].update(at(0));
  glb.add("materials",
          {{"extensions",
            {{"KHR_materials_transmission", {{"transmissionFactor", 1.0}}},
             {"KHR_materials_volume", {{"thicknessFactor", 1.0}, {"attenuationDistance", 0.5}}}}}});
  glb.primitive()["material"] = 0;
  glb.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  Json camera = at(0.5);
  camera["camera"] = 0;
  glb.add_root(camera);
  glb.add_light({{"type", "point"}}, at(0.25));
  glb.add_light({{"type", "directional"}}, at(0.25));
  return glb;
}

/// Irradiance from a lamp falls with the square of the distance, a sun's does not.
TEST_F(LoadScene, AnotherUnitChangesSizesAndNotThePicture) {
  SceneSource in_metres = source();
  in_metres.file = write("far.glb", far_and_lit().bytes());
  SceneSource in_feet = in_metres;
  in_feet.metres_per_unit = 0.25;
  const Scene metres = load_scene(in_metres);
  const Scene feet = load_scene(in_feet);
  ASSERT_NE(metres.origin, DVec3(0.0));
  EXPECT_EQ(feet.origin, 0.25 * metres.origin);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(feet.meshes.at(0).positions.at(i), 0.25F * metres.meshes.at(0).positions.at(i));
  }
  EXPECT_EQ(feet.cameras.at(0).position, 0.25F * metres.cameras.at(0).position);
  EXPECT_EQ(metres.materials.at(0).attenuation_distance_m, 0.5F);
  EXPECT_EQ(feet.materials.at(0).attenuation_distance_m, 0.125F);
  EXPECT_EQ(feet.lights.at(0).position, 0.25F * metres.lights.at(0).position);
  EXPECT_EQ(feet.lights.at(0).intensity, 0.0625F * metres.lights.at(0).intensity);
  EXPECT_EQ(feet.lights.at(1).intensity, metres.lights.at(1).intensity);
}

TEST_F(LoadScene, InstancesAreScaledWhereTheyStand) {
  SceneSource instanced = source();
  GlbBuilder glb = one_triangle();
  const int many = 40000;
  std::vector<std::uint32_t> indices;
  for (int i = 0; i < many; ++i) {
    indices.insert(indices.end(), {0, 1, 2});
  }
  glb.primitive()["indices"] = glb.add_accessor(indices, uint32, "SCALAR", 1);
  for (const double x : {3.0, -3.0}) {
    glb.add_root({{"mesh", 0}, {"translation", {x, 0, 0}}, {"scale", {2, 2, 2}}});
  }
  instanced.file = write("instances.glb", glb.bytes());
  instanced.metres_per_unit = 0.5;
  const Scene scene = load_scene(instanced);
  ASSERT_EQ(scene.instances.size(), 3U);
  EXPECT_EQ(scene.instances[1].world_from_local * Vec4(1, 0, 0, 1), Vec4(2.5F, 0, 0, 1));
  EXPECT_EQ(scene.bounds().upper, Vec3(2.5F, 1, 0));
}

/// The lights of a source stand in the file's world, like its triangles.
TEST_F(LoadScene, LightsOfFarScenesAreMovedWithThem) {
  GlbBuilder far = one_triangle();
  far.document["nodes"][0]["translation"] = {4096, 0, 0};
  SceneSource lit = source();
  lit.file = write("far.glb", far.bytes());
  lit.lights = {{.center = {4096.5F, 2, 0.5F}, .size = {2, 6}, .normal = {0, -1, 0}}};
  const Scene scene = load_scene(lit);
  ASSERT_NE(scene.origin, DVec3(0.0));
  const std::vector<Vec3>& corners = scene.meshes.at(1).positions;
  EXPECT_EQ(scene.origin + DVec3(0.5F * (corners[0] + corners[2])), DVec3(4096.5, 2, 0.5));
}

TEST_F(LoadScene, RefusesLightsThatMakeNoSense) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(error_with({.normal = {0, 0.6F, 0.8F}}),
              HasSubstr("room: lights[1]: the normal of the light is not an axis"));
  EXPECT_THAT(error_with({.normal = {0, nan, 0}}), HasSubstr("not an axis"));
  EXPECT_THAT(error_with({.size = {0, 1}}), HasSubstr("size of the light is 0 x 1;"));
  EXPECT_THAT(error_with({.size = {1, nan}}), HasSubstr("size of the light is 1 x nan;"));
  EXPECT_THAT(error_with({.center = {nan, 0, 0}}), HasSubstr("centre of the light"));
  EXPECT_THAT(error_with({.radiance = {1, -1, 1}}),
              HasSubstr("the radiance of the light is (1, -1, 1); give"));
  SceneSource dark = source();
  dark.environment_radiance = Rgb(nan);
  EXPECT_THROW(load_scene(dark), Error);
}

}  // namespace
}  // namespace foveola::test
