#include "scenes/modelling/glb_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/scenes/glb.h"

namespace foveola::scenes {
namespace {

Model small_model() {
  Model model;
  const int lamp = add_material(model, {.name = "lamp", .emission = {6.0F, 3.0F, 1.5F}});
  const int glow = add_material(model, {.name = "glow", .emission = {0.5F, 0.25F, 0.0F}});
  const int image = add_image(model, Image{2, 1, {255, 0, 0, 255, 0, 0, 255, 0}});
  const int leaf = add_material(model, {.name = "leaf",
                                        .roughness = 0.5F,
                                        .base_color_image = image,
                                        .alpha_cutoff = 0.4F,
                                        .double_sided = true});
  add_object(model, "Lamp", {{lamp, box(DVec3(1.0))}, {glow, box(DVec3(2.0))}});
  add_object(model, "Leaf", {{leaf, picture({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}});
  model.cameras.push_back({"Here", {1.0F, 2.0F, 3.0F}, {radians(90.0), radians(30.0)}});
  return model;
}

TEST(GlbWriter, HeaderAndChunksFollowTheSpecification) {
  const std::string file = glb_from(small_model());
  const Glb glb = taken_apart(file);
  EXPECT_EQ(glb.magic, 0x46546C67U);
  EXPECT_EQ(glb.version, 2U);
  EXPECT_EQ(glb.length, file.size());
  EXPECT_EQ(glb.json_type, 0x4E4F534AU);
  EXPECT_EQ(glb.json_length % 4, 0U);
  EXPECT_EQ(glb.binary_type, 0x004E4942U);
  EXPECT_EQ(glb.binary_length, glb.binary.size());
  EXPECT_EQ(glb.binary_length % 4, 0U);
  EXPECT_EQ(glb.json.at("buffers").at(0).at("byteLength"), glb.binary_length);
  EXPECT_EQ(glb.json.at("asset").at("version"), "2.0");
}

TEST(GlbWriter, ObjectsAreNodesWithOnePrimitiveASurface) {
  const nlohmann::json json = taken_apart(glb_from(small_model())).json;
  ASSERT_EQ(json.at("nodes").size(), 3U);
  EXPECT_EQ(json.at("scenes").at(0).at("nodes"), nlohmann::json({0, 1, 2}));
  EXPECT_EQ(json.at("nodes").at(0).at("name"), "Lamp");
  EXPECT_EQ(json.at("meshes").at(0).at("primitives").size(), 2U);
  EXPECT_FALSE(
      json.at("meshes").at(0).at("primitives").at(0).at("attributes").contains("TEXCOORD_0"));
  EXPECT_TRUE(
      json.at("meshes").at(1).at("primitives").at(0).at("attributes").contains("TEXCOORD_0"));
}

TEST(GlbWriter, PositionsComeWithTheirBounds) {
  const nlohmann::json json = taken_apart(glb_from(small_model())).json;
  const std::size_t positions =
      json.at("meshes").at(0).at("primitives").at(1).at("attributes").at("POSITION");
  EXPECT_EQ(json.at("accessors").at(positions).at("min"), nlohmann::json({-1.0, -1.0, -1.0}));
  EXPECT_EQ(json.at("accessors").at(positions).at("max"), nlohmann::json({1.0, 1.0, 1.0}));
}

TEST(GlbWriter, IndicesAreShortWhereThatHoldsThem) {
  Model model;
  const int paint = add_material(model, {.name = "paint"});
  const auto flat = [](double u, double v) { return DVec3(u, v, 0.0); };
  constexpr int cells = 256;
  add_object(model, "Box", {{paint, box(DVec3(1.0))}});
  add_object(model, "Sheet", {{paint, patch(cells, cells, flat)}});
  const Glb glb = taken_apart(glb_from(model));
  const auto accessor = [&](std::size_t mesh) -> std::size_t {
    return glb.json.at("meshes").at(mesh).at("primitives").at(0).at("indices");
  };
  EXPECT_EQ(items_of<std::uint16_t>(glb, accessor(0)).size(), 36U);
  const auto indices = items_of<std::uint32_t>(glb, accessor(1));
  EXPECT_EQ(*std::max_element(indices.begin(), indices.end()), (cells + 1U) * (cells + 1U) - 1U);
}

TEST(GlbWriter, EmissionBeyondOneUsesTheStrengthExtension) {
  const nlohmann::json json = taken_apart(glb_from(small_model())).json;
  const nlohmann::json& lamp = json.at("materials").at(0);
  EXPECT_EQ(lamp.at("emissiveFactor"), nlohmann::json({1.0, 0.5, 0.25}));
  EXPECT_EQ(lamp.at("extensions").at("KHR_materials_emissive_strength").at("emissiveStrength"),
            6.0);
  const nlohmann::json& glow = json.at("materials").at(1);
  EXPECT_EQ(glow.at("emissiveFactor"), nlohmann::json({0.5, 0.25, 0.0}));
  EXPECT_FALSE(glow.contains("extensions"));
  EXPECT_EQ(json.at("extensionsUsed"), nlohmann::json({"KHR_materials_emissive_strength"}));
}

TEST(GlbWriter, GlassIsTransmissiveAndExtensionsAreListedOnce) {
  Model model;
  const int glass =
      add_material(model, {.name = "glass", .roughness = 0.0F, .transmission = 0.75F});
  const int lamp = add_material(
      model, {.name = "lamp glass", .emission = {6.0F, 3.0F, 1.5F}, .transmission = 1.0F});
  add_object(model, "Window", {{glass, box(DVec3(1.0))}, {lamp, box(DVec3(2.0))}});
  const nlohmann::json json = taken_apart(glb_from(model)).json;
  const nlohmann::json& pane = json.at("materials").at(0).at("extensions");
  EXPECT_EQ(pane.size(), 1U);
  EXPECT_EQ(pane.at("KHR_materials_transmission").at("transmissionFactor"), 0.75);
  const nlohmann::json& both = json.at("materials").at(1).at("extensions");
  EXPECT_EQ(both.at("KHR_materials_transmission").at("transmissionFactor"), 1.0);
  EXPECT_EQ(both.at("KHR_materials_emissive_strength").at("emissiveStrength"), 6.0);
  EXPECT_EQ(json.at("extensionsUsed"),
            nlohmann::json({"KHR_materials_transmission", "KHR_materials_emissive_strength"}));
}

TEST(GlbWriter, VarnishIsAClearcoat) {
  Model model;
  const int paint = add_material(
      model, {.name = "paint", .metallic = 0.5F, .roughness = 0.4F, .clearcoat = 1.0F});
  const int primer = add_material(model, {.name = "primer"});
  add_object(model, "Panels", {{paint, box(DVec3(1.0))}, {primer, box(DVec3(2.0))}});
  const nlohmann::json json = taken_apart(glb_from(model)).json;
  const nlohmann::json& coat =
      json.at("materials").at(0).at("extensions").at("KHR_materials_clearcoat");
  EXPECT_EQ(coat.at("clearcoatFactor"), 1.0);
  EXPECT_GT(coat.at("clearcoatRoughnessFactor"), 0.0);
  EXPECT_LT(coat.at("clearcoatRoughnessFactor"), 0.1);
  EXPECT_FALSE(json.at("materials").at(1).contains("extensions"));
  EXPECT_EQ(json.at("extensionsUsed"), nlohmann::json({"KHR_materials_clearcoat"}));
}

TEST(GlbWriter, OpaqueMaterialsUseNoTransmission) {
  EXPECT_FALSE(
      taken_apart(glb_from(small_model())).json.at("materials").at(2).contains("extensions"));
}

TEST(GlbWriter, CutOutsAreMaskedAndTheirImageIsAPng) {
  const Glb glb = taken_apart(glb_from(small_model()));
  const nlohmann::json& leaf = glb.json.at("materials").at(2);
  EXPECT_EQ(leaf.at("alphaMode"), "MASK");
  EXPECT_FLOAT_EQ(leaf.at("alphaCutoff").get<float>(), 0.4F);
  EXPECT_EQ(leaf.at("doubleSided"), true);
  EXPECT_EQ(leaf.at("pbrMetallicRoughness").at("baseColorTexture").at("index"), 0);
  EXPECT_EQ(glb.json.at("images").at(0).at("mimeType"), "image/png");
  const std::size_t view = glb.json.at("images").at(0).at("bufferView");
  const std::size_t offset = glb.json.at("bufferViews").at(view).at("byteOffset");
  EXPECT_EQ(glb.binary.substr(offset, 8), "\x89PNG\r\n\x1a\n");
  constexpr std::size_t color_type_offset = 25;  // PNG specification (W3C 2003), 11.2.2
  constexpr char rgba = 6;
  EXPECT_EQ(glb.binary.at(offset + color_type_offset), rgba);
}

TEST(GlbWriter, CameraLooksAlongItsHeading) {
  const nlohmann::json json = taken_apart(glb_from(small_model())).json;
  const nlohmann::json& node = json.at("nodes").at(2);
  EXPECT_EQ(node.at("translation"), nlohmann::json({1.0, 2.0, 3.0}));
  const auto q = node.at("rotation").get<std::array<float, 4>>();
  // glTF's cameras look along -Z; azimuth 90 degrees is +X, elevation 30 degrees is up.
  const Vec3 look = Quat(q[3], q[0], q[1], q[2]) * Vec3(0.0F, 0.0F, -1.0F);
  EXPECT_NEAR(look.x, std::cos(radians(30.0)), 1e-6);
  EXPECT_NEAR(look.y, 0.5, 1e-6);
  EXPECT_NEAR(look.z, 0.0, 1e-6);
}

TEST(GlbWriter, SameModelGivesTheSameBytes) {
  EXPECT_EQ(glb_from(small_model()), glb_from(small_model()));
}

}  // namespace
}  // namespace foveola::scenes
