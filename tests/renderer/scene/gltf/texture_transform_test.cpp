#include <gmock/gmock.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

const Json untransformed = Json::object();

/// Where the corners of the unit square of coordinates go under KHR_texture_transform.
class TextureTransform : public LoadGltf {
 protected:
  Vec2 transformed(const Json& transform, const Vec2& uv) const {
    GlbBuilder glb = with_material(untransformed);
    Json material = textured(glb.add_texture(one_pixel(1, 2, 3)));
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform", transform}};
    glb.document["materials"][0] = material;
    const TextureUse use = load(glb).materials.at(0).base_color_texture;
    return use.texture_from_mesh * Vec3(uv, 1.0F);
  }
};

TEST_F(TextureTransform, WithoutOneCoordinatesStay) {
  EXPECT_EQ(transformed(untransformed, {0.25F, 0.75F}), Vec2(0.25F, 0.75F));
}

TEST_F(TextureTransform, ScalesThenMoves) {
  const Json transform = {{"offset", {0.5, 0.25}}, {"scale", {2, -1}}};
  EXPECT_EQ(transformed(transform, {0.25F, 0.75F}), Vec2(1.0F, -0.5F));
}

/// The extension's own example: "utilizes only the lower left quadrant of the source image, rotated
/// clockwise 90 degrees". The image's upper left corner is (0, 0), so that quadrant is u in
/// [0, 0.5], v in [0.5, 1]. With the quadrant turned clockwise, its lower left corner (0, 1) is
/// seen at the upper left of the mesh (0, 0), its upper left (0, 0.5) at the upper right (1, 0),
/// its lower right (0.5, 1) at the lower left (0, 1).
TEST_F(TextureTransform, RotatesAsInTheExtensionsExample) {
  const Json transform = {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}};
  const auto expect_near = [](const Vec2& actual, const Vec2& expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-6F);
    EXPECT_NEAR(actual.y, expected.y, 1e-6F);
  };
  expect_near(transformed(transform, {0, 0}), {0, 1});
  expect_near(transformed(transform, {1, 0}), {0, 0.5F});
  expect_near(transformed(transform, {0, 1}), {0.5F, 1});
}

TEST_F(TextureTransform, OverridesTheSetOfCoordinates) {
  GlbBuilder glb = with_material(untransformed);
  Json material = textured(glb.add_texture(one_pixel(1, 2, 3)), 0);
  material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform", {{"texCoord", 1}}}};
  glb.document["materials"][0] = material;
  EXPECT_EQ(load(glb).meshes.at(0).uv_sets.at(0).at(0), Vec2(5, 5));
}

}  // namespace
}  // namespace foveola::test
