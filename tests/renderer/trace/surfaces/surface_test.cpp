#include "renderer/trace/surfaces/surface.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "tests/renderer/trace/scenes.h"

namespace foveola {
namespace {

/// A unit square on the floor whose front looks up.
Scene floor_made_of(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.meshes = {quad(Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, -1), 0)};
  return scene;
}

const Hit centre{.t = 1.0F, .barycentric = {0.0F, 0.5F}, .object = 0, .triangle = 0};
const Vec3 down(0, -1, 0);
const Vec3 up(0, 1, 0);

TEST(SurfaceTest, RaysLeaveOnTheSideTheyCameFrom) {
  const Scene scene = floor_made_of(dielectric(0.5F));
  const SurfacePoint above = surface_point(scene, centre, down);
  EXPECT_EQ(above.geometric_normal, up);
  EXPECT_GT(above.origin.y, 0.0F);
  EXPECT_LT(above.origin.y, 1e-4F);
  EXPECT_NEAR(above.origin.x, 0.5, 1e-6);
  const SurfacePoint below = surface_point(scene, centre, up);
  EXPECT_EQ(below.geometric_normal, down);
  EXPECT_LT(below.origin.y, 0.0F);
}

/// Where two walls meet, a wall that is grazed is found anywhere on a long stretch of the ray.
TEST(SurfaceTest, RaysStartWhereTheGrazingOneCameAlong) {
  const Vec3 direction = glm::normalize(Vec3(1.0F, -0.005F, 0.0F));
  const Vec3 on_the_ray = origin_before(Vec3(0.0F), direction, up, 2.0F, 1e-6F);
  EXPECT_NEAR(on_the_ray.x, -2e-4F, 1e-8F);
  EXPECT_NEAR(on_the_ray.y, 1e-6F, 1e-11F);
  const Vec3 after_a_short_way = origin_before(Vec3(0.0F), direction, up, 1e-4F, 1e-6F);
  EXPECT_NEAR(after_a_short_way.x, -5e-5F, 1e-8F) << "half of it";
  EXPECT_NEAR(after_a_short_way.y, 1e-6F, 1e-11F) << "off the wall all the same";
  const Vec3 along_the_wall = origin_before(Vec3(0.0F), Vec3(1, 0, 0), up, 2.0F, 1e-6F);
  EXPECT_EQ(along_the_wall, Vec3(-1.0F, 1e-6F, 0.0F));
}

TEST(SurfaceTest, ShadingNormalIsInterpolatedOnTheRaysSide) {
  Scene scene = floor_made_of(dielectric(0.5F));
  const Vec3 tilted = glm::normalize(Vec3(0.2F, 1.0F, 0.0F));
  scene.meshes[0].normals.assign(4, tilted);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - tilted), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, up).shading_normal + tilted), 0.0, 1e-6);
  // Normals that an exporter turned inside out.
  scene.meshes[0].normals.assign(4, -tilted);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - tilted), 0.0, 1e-6);
}

TEST(SurfaceTest, ShadingNormalWithoutDirectionOrTurnedAwayIsTheGeometricOne) {
  Scene scene = floor_made_of(dielectric(0.5F));
  scene.meshes[0].normals.assign(4, Vec3(0.0F));
  EXPECT_EQ(surface_point(scene, centre, down).shading_normal, up);
  scene.meshes[0].normals.assign(4, glm::normalize(Vec3(1.0F, 0.1F, 0.0F)));
  const Vec3 grazing = glm::normalize(Vec3(1.0F, -0.05F, 0.0F));
  EXPECT_EQ(surface_point(scene, centre, grazing).shading_normal, up);
}

TEST(SurfaceTest, TexturesMultiplyTheFactors) {
  Material material = dielectric(0.5F, 0.8F);
  material.metallic = 1.0F;
  material.base_color_texture.texture = 0;
  material.metallic_roughness_texture.texture = 1;
  Scene scene = floor_made_of(material);
  const std::vector<std::uint8_t> base{255, 51, 0, 255};
  const std::vector<std::uint8_t> metallic_roughness{9, 51, 102, 255};
  scene.textures.emplace_back(1, 1, base, false, Wrap::repeat, Wrap::repeat);
  scene.textures.emplace_back(1, 1, metallic_roughness, false, Wrap::repeat, Wrap::repeat);
  const Reflectance reflectance = surface_point(scene, centre, down).reflectance;
  EXPECT_NEAR(reflectance.base_color.r, 0.5, 1e-6);
  EXPECT_NEAR(reflectance.base_color.g, 0.1, 1e-6);
  EXPECT_NEAR(reflectance.roughness, 0.8 * 0.2, 1e-6);
  EXPECT_NEAR(reflectance.metallic, 0.4, 1e-6);
}

TEST(SurfaceTest, SingleSidedEmittersShineFromTheirFront) {
  const Scene scene = floor_made_of(emitter(3.0F));
  const Vec3 slanted = glm::normalize(Vec3(0.0F, -0.6F, 0.8F));
  EXPECT_EQ(surface_emission(scene, centre, slanted).radiance, Rgb(3.0F));
  EXPECT_NEAR(surface_emission(scene, centre, slanted).cosine, 0.6, 1e-6);
  EXPECT_EQ(surface_emission(scene, centre, up).radiance, Rgb(0.0F));
}

// KHR_materials_clearcoat, "Emission": what is left is 1 - clearcoat * F, by Schlick's F of 0.04.
TEST(SurfaceTest, AClearCoatReflectsItsShareOfTheEmissionBack) {
  Material material = emitter(2.0F);
  material.clearcoat = 1.0F;
  Scene scene = floor_made_of(material);
  const auto emission = [&](double angle_deg) {
    const double angle = radians(angle_deg);
    return surface_emission(scene, centre, Vec3(std::sin(angle), -std::cos(angle), 0.0)).radiance.g;
  };
  EXPECT_NEAR(emission(0.0), 1.920, 5e-4);
  EXPECT_NEAR(emission(60.0), 1.860, 5e-4);
  EXPECT_NEAR(emission(80.0), 1.180, 5e-4);
  scene.materials[0].clearcoat = 0.5F;
  EXPECT_NEAR(emission(80.0), 0.5 * (2.0 + 1.180), 5e-4);
  // The coat's own normal, leaning towards the ray by 60 degrees.
  scene.meshes[0].normals.assign(
      4, direction_from({.azimuth_rad = -0.5 * std::numbers::pi, .elevation_rad = radians(30.0)}));
  scene.materials[0].clearcoat = 1.0F;
  EXPECT_NEAR(emission(60.0), 1.920, 5e-4);
}

TEST(SurfaceTest, DoubleSidedEmittersShineBothWays) {
  const Scene scene = floor_made_of(emitter(3.0F, true));
  EXPECT_EQ(surface_emission(scene, centre, up).radiance, Rgb(3.0F));
  EXPECT_EQ(surface_emission(scene, centre, up).cosine, 1.0F);
}

TEST(SurfaceTest, VertexColoursMultiplyTheBaseColour) {
  Scene scene = floor_made_of(dielectric(0.5F));
  scene.meshes[0].colors = {{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0.5F, 0, 1}, {1, 0.5F, 0, 1}};
  const Rgb color = surface_point(scene, centre, down).reflectance.base_color;
  EXPECT_NEAR(color.r, 0.5, 1e-6);
  EXPECT_NEAR(color.g, 0.125, 1e-6);
  EXPECT_EQ(color.b, 0.0F);
}

TEST(SurfaceTest, TextureTransformAndUvSetAreApplied) {
  Material material = dielectric(1.0F);
  material.base_color_texture = {
      .texture = 0, .uv_set = 1, .texture_from_mesh = {0.0F, 1.0F, -1.0F, 0.0F, 1.0F, 0.0F}};
  Scene scene = floor_made_of(material);
  // Four texels in a row; the second set of coordinates runs along them after a quarter turn.
  const std::vector<std::uint8_t> row{0, 0, 0, 255, 85, 0, 0, 255, 170, 0, 0, 255, 255, 0, 0, 255};
  scene.textures.emplace_back(4, 1, row, false, Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  scene.meshes[0].uv_sets.push_back({{0, 0.625F}, {0, 0.625F}, {0, 0.625F}, {0, 0.625F}});
  // u' = 1 - v = 0.375, the middle of the second texel.
  EXPECT_NEAR(surface_point(scene, centre, down).reflectance.base_color.r, 1.0 / 3.0, 1e-6);
}

TEST(SurfaceTest, WideRaysSeeTheMeanOfATexture) {
  Material material = dielectric(1.0F);
  material.base_color_texture.texture = 0;
  Scene scene = floor_made_of(material);
  std::vector<std::uint8_t> checkers;
  for (int i = 0; i < 64 * 64; ++i) {
    const auto value = static_cast<std::uint8_t>((i + i / 64) % 2 * 255);
    checkers.insert(checkers.end(), {value, value, value, 255});
  }
  scene.textures.emplace_back(64, 64, checkers, false, Wrap::repeat, Wrap::repeat);
  EXPECT_NEAR(surface_point(scene, centre, down, 2.0F).reflectance.base_color.r, 0.5, 0.01);
}

/// The floor shows the left half of a picture, whose other half is white.
TEST(SurfaceTest, WideRaysSeeNothingBeyondTheirTriangle) {
  Material material = dielectric(1.0F);
  material.base_color_texture.texture = 0;
  Scene scene = floor_made_of(material);
  for (Vec2& uv : scene.meshes[0].uv_sets[0]) {
    uv.x *= 0.5F;
  }
  std::vector<std::uint8_t> halves;
  for (int i = 0; i < 64 * 64; ++i) {
    const std::uint8_t value = i % 64 < 32 ? 51 : 255;
    halves.insert(halves.end(), {value, value, value, 255});
  }
  scene.textures.emplace_back(64, 64, halves, false, Wrap::repeat, Wrap::repeat);
  EXPECT_NEAR(surface_point(scene, centre, down, 20.0F).reflectance.base_color.r, 0.2, 1e-5);
}

/// The floor's u runs along +x, its v along +z (towards the viewer), as its corners say.
Scene floor_with_normal_map(const std::vector<std::uint8_t>& texel) {
  Material material = dielectric(0.5F);
  material.normal_texture.texture = 0;
  Scene scene = floor_made_of(material);
  scene.textures.emplace_back(1, 1, texel, false, Wrap::repeat, Wrap::repeat);
  scene.meshes[0].tangents.assign(4, Vec4(1, 0, 0, 1));
  return scene;
}

// A texel of (x, y, z) = 2 c - 1 stands for x T + y B + z N with B = w (N x T) (glTF 2.0, 3.9.3).
TEST(SurfaceTest, NormalTextureTiltsTheNormalInItsTangentFrame) {
  const Vec3 texel = 2.0F * Vec3(204, 153, 230) / 255.0F - 1.0F;
  const Scene scene = floor_with_normal_map({204, 153, 230, 255});
  const Vec3 bitangent(0, 0, -1);
  const Vec3 expected =
      glm::normalize(texel.x * Vec3(1, 0, 0) + texel.y * bitangent + texel.z * up);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - expected), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, up).shading_normal + expected), 0.0, 1e-6)
      << "from behind, the same surface seen from the other side";
}

TEST(SurfaceTest, AClearCoatHasItsOwnNormalTextureOrNone) {
  Scene scene = floor_with_normal_map({204, 153, 230, 255});
  const SurfacePoint base_mapped = surface_point(scene, centre, down);
  EXPECT_EQ(base_mapped.coat_normal, up);
  std::swap(scene.materials[0].normal_texture, scene.materials[0].clearcoat_normal_texture);
  const SurfacePoint coat_mapped = surface_point(scene, centre, down);
  EXPECT_EQ(coat_mapped.coat_normal, base_mapped.shading_normal);
  EXPECT_EQ(coat_mapped.shading_normal, up);
  scene.materials[0].clearcoat_normal_scale = 0.0F;
  EXPECT_NEAR(glm::distance(surface_point(scene, centre, down).coat_normal, up), 0.0, 1e-6);
}

TEST(SurfaceTest, NormalScaleMultipliesTheTilt) {
  Scene scene = floor_with_normal_map({204, 128, 230, 255});
  scene.materials[0].normal_scale = 0.0F;
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - up), 0.0, 1e-6);
}

TEST(SurfaceTest, AMirroredInstanceMirrorsItsNormalMap) {
  Scene scene = floor_with_normal_map({204, 128, 230, 255});
  const Vec3 tilted = surface_point(scene, centre, down).shading_normal;
  scene.meshes[0].normals.assign(4, up);
  scene.prototypes = {scene.meshes[0]};
  scene.meshes.clear();
  Mat4 world_from_local(1.0F);
  world_from_local[0].x = -1.0F;
  scene.instances = {{.name = "", .prototype = 0, .world_from_local = world_from_local}};
  const Vec3 mirrored = surface_point(scene, centre, down).shading_normal;
  EXPECT_NEAR(glm::length(mirrored - Vec3(-tilted.x, tilted.y, tilted.z)), 0.0, 1e-6);
}

// T = exp(-d * absorption) must be the attenuation colour at the attenuation distance.
TEST(SurfaceTest, AbsorptionLeavesTheAttenuationColourAtItsDistance) {
  Material material;
  material.is_solid = true;
  material.attenuation_color = Rgb(0.5F, 0.25F, 1.0F);
  material.attenuation_distance_m = 2.0F;
  const Rgb left = glm::exp(-2.0F * absorption_per_m(material));
  EXPECT_NEAR(left.r, 0.5, 1e-6);
  EXPECT_NEAR(left.g, 0.25, 1e-6);
  EXPECT_NEAR(left.b, 1.0, 1e-6);
  material.attenuation_distance_m = std::numeric_limits<float>::infinity();
  EXPECT_EQ(absorption_per_m(material), Rgb(0.0F));
}

}  // namespace
}  // namespace foveola
