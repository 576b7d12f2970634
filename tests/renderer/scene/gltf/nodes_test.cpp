#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <vector>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// The unit quaternion (x, y, z, w) of a quarter turn about +Z.
Json quarter_turn() { return {0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)}; }

/// nodes[0] with mesh 0 under the given parents, outermost last; only the last is a root.
GlbBuilder nested(std::initializer_list<Json> transforms) {
  GlbBuilder glb = one_triangle();
  glb.document["nodes"] = Json::array();
  int below = -1;
  for (Json node : transforms) {
    if (below < 0) {
      node["mesh"] = 0;
    } else {
      node["children"] = {below};
    }
    below = glb.add("nodes", node);
  }
  glb.document["scenes"][0]["nodes"] = {below};
  return glb;
}

/// Where vertex `i` of mesh `mesh` stands in the file's world.
Vec3 world_position(const Scene& scene, std::size_t mesh, std::size_t i) {
  return Vec3(scene.origin + DVec3(scene.meshes.at(mesh).positions.at(i)));
}

using Nodes = LoadGltf;

TEST_F(Nodes, ScaleThenRotationThenTranslation) {
  const Scene scene = load(nested(
      {{{"translation", {10, 20, 30}}, {"rotation", quarter_turn()}, {"scale", {2, 3, 4}}}}));
  expect_vec_near(world_position(scene, 0, 0), {10, 20, 30});
  expect_vec_near(world_position(scene, 0, 1), {10, 22, 30});  // (2, 0, 0) turned to (0, 2, 0)
  expect_vec_near(world_position(scene, 0, 2), {7, 20, 30});   // (0, 3, 0) turned to (-3, 0, 0)
}

TEST_F(Nodes, ParentsApplyAfterTheirChildren) {
  const Scene scene = load(nested(
      {{{"translation", {1, 0, 0}}}, {{"rotation", quarter_turn()}}, {{"scale", {2, 2, 2}}}}));
  expect_vec_near(world_position(scene, 0, 0), {0, 2, 0});
  expect_vec_near(world_position(scene, 0, 1), {0, 4, 0});
  expect_vec_near(world_position(scene, 0, 2), {-2, 2, 0});
}

TEST_F(Nodes, MatrixIsColumnMajor) {
  const Scene scene =
      load(nested({{{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}}));
  expect_vec_near(world_position(scene, 0, 0), {5, 6, 7});
  expect_vec_near(world_position(scene, 0, 1), {5, 7, 7});
  expect_vec_near(world_position(scene, 0, 2), {4, 6, 7});
}

/// In float, 1e8 + 0.5 is 1e8.
TEST_F(Nodes, ComposesInDoublePrecision) {
  const Scene scene =
      load(nested({{{"translation", {1e8 + 0.5, 0, 0}}}, {{"translation", {-1e8, 0, 0}}}}));
  expect_vec_near(world_position(scene, 0, 0), {0.5F, 0, 0});
}

TEST_F(Nodes, EveryInstanceIsACopyWithItsOwnName) {
  GlbBuilder glb = one_triangle();
  glb.document["meshes"][0]["name"] = "chair";
  glb.add_root({{"mesh", 0}, {"name", "left chair"}, {"translation", {-5, 0, 0}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.meshes.size(), 2U);
  EXPECT_EQ(scene.meshes[0].name, "chair");
  EXPECT_EQ(scene.meshes[1].name, "left chair");
  expect_vec_near(world_position(scene, 0, 1), {1, 0, 0});
  expect_vec_near(world_position(scene, 1, 1), {-4, 0, 0});
}

TEST_F(Nodes, OnlyTheDefaultSceneIsShown) {
  GlbBuilder glb = one_triangle();
  glb.add("nodes", {{"mesh", 0}, {"translation", {7, 0, 0}}});
  glb.add("scenes", {{"nodes", {1}}});
  EXPECT_EQ(world_position(load(glb), 0, 0).x, 0.0F) << "without a default, the first";
  glb.document["scene"] = 1;
  const Scene scene = load(glb);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(world_position(scene, 0, 0).x, 7.0F);
}

TEST_F(Nodes, WithoutScenesAllRootsAreShown) {
  GlbBuilder glb = one_triangle();
  glb.document.erase("scenes");
  glb.document["nodes"][0]["children"] = {1};
  glb.add("nodes", {{"mesh", 0}, {"translation", {7, 0, 0}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.meshes.size(), 2U);
  EXPECT_EQ(world_position(scene, 1, 0).x, 7.0F);
}

TEST_F(Nodes, PerspectiveCamerasLookAlongMinusZ) {
  GlbBuilder glb = one_triangle();
  const Json lens = {{"yfov", 1.0}, {"znear", 0.1}};
  glb.add("cameras", {{"type", "perspective"}, {"name", "eye"}, {"perspective", lens}});
  glb.add_root({{"camera", 0}, {"translation", {1, 2, 3}}});
  // Half of a right angle about +Y, to the left: towards -X and -Z.
  const double eighth = std::numbers::pi / 8.0;
  glb.add_root({{"camera", 0}, {"rotation", {0, std::sin(eighth), 0, std::cos(eighth)}}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[0].name, "eye");
  expect_vec_near(scene.cameras[0].position, {1, 2, 3});
  EXPECT_NEAR(scene.cameras[0].heading.azimuth_rad, 0.0, 1e-6);
  EXPECT_NEAR(scene.cameras[0].heading.elevation_rad, 0.0, 1e-6);
  EXPECT_NEAR(scene.cameras[1].heading.azimuth_rad, -std::numbers::pi / 4.0, 1e-6);
}

TEST_F(Nodes, CamerasKeepTheirFieldOfViewAndAspectRatio) {
  GlbBuilder glb = one_triangle();
  glb.add("cameras", {{"type", "perspective"},
                      {"perspective", {{"yfov", 0.75}, {"aspectRatio", 1.5}, {"znear", 0.1}}}});
  glb.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 4.0}, {"znear", 0.1}}}});
  glb.add("cameras", {{"type", "perspective"}});
  glb.add_root({{"camera", 0}});
  glb.add_root({{"camera", 1}});
  glb.add_root({{"camera", 2}});
  const Scene scene = load(glb);
  ASSERT_EQ(scene.cameras.size(), 3U);
  EXPECT_EQ(scene.cameras[0].vertical_fov_rad, 0.75);
  EXPECT_EQ(scene.cameras[0].aspect_ratio, 1.5);
  EXPECT_FALSE(scene.cameras[1].vertical_fov_rad) << "over half a turn";
  EXPECT_FALSE(scene.cameras[1].aspect_ratio);
  EXPECT_FALSE(scene.cameras[2].vertical_fov_rad) << "without a lens";
}

/// A triangle, and a camera turned by this quaternion (x, y, z, w).
GlbBuilder with_turned_camera(const Json& rotation) {
  GlbBuilder glb = one_triangle();
  glb.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  glb.add_root({{"camera", 0}, {"rotation", rotation}});
  return glb;
}

/// A quaternion for a turn about an axis of unit length.
Json turn(double degrees, const Vec3& axis) {
  const double half = degrees * std::numbers::pi / 360.0;
  return {axis.x * std::sin(half), axis.y * std::sin(half), axis.z * std::sin(half),
          std::cos(half)};
}

TEST_F(Nodes, LevelCamerasDoNotRoll) {
  for (const Json& level : {turn(77, {0, 1, 0}), turn(-60, {1, 0, 0}), turn(89, {1, 0, 0}),
                            turn(-90, {1, 0, 0}), turn(180, {0, 1, 0})}) {
    const Scene scene = load(with_turned_camera(level));
    EXPECT_THAT(scene.warnings, IsEmpty()) << level;
    EXPECT_EQ(scene.cameras.at(0).roll_rad, 0.0) << level;
  }
}

TEST_F(Nodes, CamerasThatLookStraightDownHaveTheirTopAhead) {
  GlbBuilder glb = with_turned_camera(turn(-90, {1, 0, 0}));
  glb.document["nodes"].back()["translation"] = {0, 5, 0};
  glb.add("nodes", {{"children", {1}}, {"rotation", turn(-30, {0, 1, 0})}});
  glb.document["scenes"][0]["nodes"] = {0, 2};
  const Scene scene = load(glb);
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_NEAR(scene.cameras.at(0).heading.elevation_rad, -std::numbers::pi / 2.0, 1e-6);
  EXPECT_NEAR(scene.cameras.at(0).heading.azimuth_rad, std::numbers::pi / 6.0, 1e-6);
}

TEST_F(Nodes, WarnsOfCamerasThatRoll) {
  const std::string warning =
      "camera roll is used by 'foveola render' only; previews and panoramas keep the horizon level "
      "(nodes[1])";
  for (const Json& rolled : {turn(1, {0, 0, 1}), turn(-30, {0, 0, 1}), turn(180, {0, 0, 1})}) {
    const Scene scene = load(with_turned_camera(rolled));
    EXPECT_THAT(scene.warnings, ElementsAre(warning)) << rolled;
    EXPECT_NEAR(scene.cameras.at(0).heading.azimuth_rad, 0.0, 1e-6);
  }
  // Turned counter-clockwise about +Z, which points at whoever looks along -Z.
  EXPECT_NEAR(load(with_turned_camera(turn(-30, {0, 0, 1}))).cameras.at(0).roll_rad,
              std::numbers::pi / 6.0, 1e-6);
  GlbBuilder two = with_turned_camera(turn(30, {0, 0, 1}));
  two.add_root({{"camera", 0}, {"rotation", turn(40, {0, 0, 1})}});
  EXPECT_THAT(load(two).warnings, ElementsAre(HasSubstr("(2 times, first at nodes[1])")));
}

TEST_F(Nodes, OrthographicCamerasAreIgnoredWithAWarning) {
  GlbBuilder glb = one_triangle();
  const Json lens = {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 9.0}};
  glb.add("cameras", {{"type", "orthographic"}, {"orthographic", lens}});
  glb.add_root({{"camera", 0}});
  const Scene scene = load(glb);
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_THAT(scene.warnings.at(0), HasSubstr("orthographic cameras"));
}

TEST_F(Nodes, RefusesWhatIsNoForest) {
  const Json mesh = {{"mesh", 0}};
  const auto parent_of = [](int node) { return Json{{"children", {node}}}; };
  for (const auto& [nodes, roots, fault] : std::vector<std::tuple<Json, Json, const char*>>{
           {{mesh, parent_of(2), parent_of(1)}, {0}, "nodes[1]: the nodes form a cycle"},
           {{{{"mesh", 0}, {"children", {0}}}}, {0}, "nodes[0]: the nodes form a cycle"},
           {{mesh, parent_of(0), parent_of(0)},
            {0},
            "nodes[2].children[0]: node 0 has two parents, nodes 1 and 2"},
           {{mesh, parent_of(0)}, {0}, "scenes[0].nodes[0]: node 0 is not a root"},
           {Json::array({mesh}), {0, 0}, "scenes[0].nodes[1]: node 0 is listed twice"}}) {
    GlbBuilder glb = one_triangle();
    glb.document["nodes"] = nodes;
    glb.document["scenes"][0]["nodes"] = roots;
    EXPECT_THAT(error_of(glb), HasSubstr(fault));
  }
}

TEST_F(Nodes, RefusesARotationOfNoLength) {
  EXPECT_THAT(error_of(nested({{{"rotation", {0, 0, 0, 0}}}})),
              HasSubstr("nodes[0].rotation: is not a rotation"));
}

TEST_F(Nodes, RefusesATransformThatOverflows) {
  EXPECT_THAT(error_of(nested({{{"scale", {1e200, 1, 1}}}, {{"scale", {1e200, 1, 1}}}})),
              HasSubstr("nodes[0]: its transform is not finite"));
}

TEST_F(Nodes, ADeepChainIsNoProblem) {
  GlbBuilder glb = one_triangle();
  constexpr int depth = 100000;
  glb.document["nodes"] = Json::array({{{"mesh", 0}}});
  for (int i = 1; i < depth; ++i) {
    glb.add("nodes", {{"children", {i - 1}}});
  }
  glb.document["nodes"][depth / 2]["translation"] = {0, 0, 5};
  glb.document["scenes"][0]["nodes"] = {depth - 1};
  EXPECT_EQ(world_position(load(glb), 0, 0).z, 5.0F);
}

/// EXT_mesh_gpu_instancing: the node's transform comes after the instance's T R S.
TEST_F(Nodes, InstancesStandWhereTheirAttributesSay) {
  GlbBuilder glb = one_triangle();
  const int places = glb.add_vectors({{-1, 0, 0}, {0, 0, 0}, {1, 0, 5}});
  const int scales = glb.add_vectors({{1, 1, 1}, {2, 2, 2}, {1, 1, 1}});
  const auto turn = static_cast<std::int8_t>(std::lround(127 * std::sqrt(0.5)));
  const int turns = glb.add_accessor(
      std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 0, 127, 0, 0, turn, turn}, int8, "VEC4", 4);
  glb.document["accessors"][turns]["normalized"] = true;
  glb.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  Json& node = glb.document["nodes"][0];
  node["translation"] = {0, 10, 0};
  Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", places}, {"SCALE", scales}, {"ROTATION", turns}};
  const Scene scene = load(glb);
  EXPECT_THAT(scene.warnings, IsEmpty());
  ASSERT_EQ(scene.meshes.size(), 3U);
  expect_vec_near(world_position(scene, 0, 1), {0, 10, 0});
  expect_vec_near(world_position(scene, 1, 1), {2, 10, 0});
  expect_vec_near(world_position(scene, 2, 1), {1, 11, 5});  // (1, 0, 0) turned to (0, 1, 0)
  attributes["SCALE"] = glb.add_vectors({{1, 1, 1}});
  EXPECT_THAT(error_of(glb), HasSubstr("attributes.SCALE: has another number of instances"));
}

/// KHR_node_visibility: and all that is below it; a light as well, whose node is one of these.
TEST_F(Nodes, HiddenOnesAreNotShown) {
  GlbBuilder glb = nested({Json::object(), Json::object()});
  glb.document["extensionsRequired"] = {"KHR_node_visibility"};
  glb.document["extensionsUsed"] = {"KHR_lights_punctual"};
  glb.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  glb.document["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  Json& visibility = glb.document["nodes"][1]["extensions"]["KHR_node_visibility"];
  visibility = {{"visible", true}};
  EXPECT_EQ(load(glb).meshes.size(), 1U);
  EXPECT_EQ(load(glb).lights.size(), 1U);
  visibility = {{"visible", false}};
  EXPECT_TRUE(load(glb).meshes.empty());
  EXPECT_TRUE(load(glb).lights.empty());
}

}  // namespace
}  // namespace foveola::test
