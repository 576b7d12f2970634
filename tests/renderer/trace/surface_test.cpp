#include "renderer/trace/surface.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace foveola {
namespace {

/// A unit square on the floor whose front looks up.
Scene floor_scene(const Material& material) {
  Scene scene;
  scene.materials = {material};
  scene.meshes = {quad(Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, -1), 0)};
  return scene;
}

const Hit centre{.t = 1.0F, .barycentric = {0.0F, 0.5F}, .object = 0, .triangle = 0};
const Vec3 down(0, -1, 0);
const Vec3 up(0, 1, 0);

TEST(SurfaceTest, RaysLeaveOnTheSideTheyCameFrom) {
  const Scene scene = floor_scene(dielectric(0.5F));
  const SurfacePoint above = surface_point(scene, centre, down);
  EXPECT_EQ(above.geometric_normal, up);
  EXPECT_GT(above.origin().y, 0.0F);
  EXPECT_LT(above.origin().y, 1e-4F);
  EXPECT_NEAR(above.origin().x, 0.5, 1e-6);
  const SurfacePoint below = surface_point(scene, centre, up);
  EXPECT_EQ(below.geometric_normal, down);
  EXPECT_LT(below.origin().y, 0.0F);
}

TEST(SurfaceTest, ShadingNormalIsInterpolatedOnTheRaysSide) {
  Scene scene = floor_scene(dielectric(0.5F));
  const Vec3 tilted = glm::normalize(Vec3(0.2F, 1.0F, 0.0F));
  scene.meshes[0].normals.assign(4, tilted);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - tilted), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, up).shading_normal + tilted), 0.0, 1e-6);
  // Normals that an exporter turned inside out.
  scene.meshes[0].normals.assign(4, -tilted);
  EXPECT_NEAR(glm::length(surface_point(scene, centre, down).shading_normal - tilted), 0.0, 1e-6);
}

TEST(SurfaceTest, ShadingNormalWithoutDirectionOrTurnedAwayIsTheGeometricOne) {
  Scene scene = floor_scene(dielectric(0.5F));
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
  Scene scene = floor_scene(material);
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
  const Scene scene = floor_scene(emitter(3.0F));
  const Vec3 slanted = glm::normalize(Vec3(0.0F, -0.6F, 0.8F));
  EXPECT_EQ(surface_emission(scene, centre, slanted).radiance, Rgb(3.0F));
  EXPECT_NEAR(surface_emission(scene, centre, slanted).cosine, 0.6, 1e-6);
  EXPECT_EQ(surface_emission(scene, centre, up).radiance, Rgb(0.0F));
}

TEST(SurfaceTest, DoubleSidedEmittersShineBothWays) {
  const Scene scene = floor_scene(emitter(3.0F, true));
  EXPECT_EQ(surface_emission(scene, centre, up).radiance, Rgb(3.0F));
  EXPECT_EQ(surface_emission(scene, centre, up).cosine, 1.0F);
}

}  // namespace
}  // namespace foveola
