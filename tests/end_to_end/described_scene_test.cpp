// `foveola scene describe` as a user types it.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/files.h"
#include "renderer/glb/glb_document.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/own_scene.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// The room, in which small boxes of these names stand before the camera, in a row from the left.
std::string room_with(const std::vector<std::string>& names) {
  auto room = nlohmann::json::parse(room_gltf());
  room["meshes"].push_back({{"primitives", {room["meshes"][0]["primitives"][0]}}});
  room["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  room["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 1.5}}});
  room["scenes"][0]["nodes"] = {0, 1};
  double x = -0.6;
  for (const std::string& name : names) {
    room["scenes"][0]["nodes"].push_back(room["nodes"].size());
    room["nodes"].push_back({{"name", name},
                             {"mesh", 1},
                             {"translation", {x, -0.3, -1.0}},
                             {"scale", {0.12, 0.1, 0.1}}});
    x += 1.2;
  }
  return glb_container(room.dump(), "");
}

class DescribedScene : public OwnScene {
 protected:
  DescribedScene() {
    write("kitchen.glb", room_with({"Crate", "Chest"}));
    std::filesystem::remove(path("kitchen.toml"));
  }
  ProgramResult describe(const std::vector<std::string>& options = {}) const {
    return run(joined({"scene", "describe", path("kitchen.glb")}, options));
  }
};

TEST_F(DescribedScene, HasObjectsForAStudy) {
  const ProgramResult described = succeeded(describe());
  EXPECT_THAT(described.output, AllOf(HasSubstr("kitchen.toml: 2 objects to choose from"),
                                      HasSubstr("Crate: radius"), HasSubstr("Chest: radius")));
  const std::string descriptor = read_file(path("kitchen.toml"));
  EXPECT_THAT(descriptor, AllOf(HasSubstr("position = [0, 0, 1.5]"), HasSubstr("azimuth_deg = 0"),
                                HasSubstr("name = \"Crate\""), HasSubstr("sha256 = \"")));
  EXPECT_THAT(descriptor, Not(HasSubstr("\"room\"")));
  succeeded(run({"study", "check", path("study.toml")}));
  succeeded(simulate());
}

/// The room with a camera that is turned and rolled.
std::string room_with_rolled_camera() {
  auto room = nlohmann::json::parse(room_gltf());
  const glm::dquat rotation = glm::angleAxis(0.3, glm::dvec3(0.0, 1.0, 0.0)) *
                              glm::angleAxis(-0.2, glm::dvec3(1.0, 0.0, 0.0)) *
                              glm::angleAxis(0.4, glm::dvec3(0.0, 0.0, 1.0));
  room["cameras"] = {
      {{"type", "perspective"},
       {"perspective", {{"yfov", radians(40.0)}, {"aspectRatio", 1.25}, {"znear", 0.1}}}}};
  room["nodes"].push_back({{"camera", 0},
                           {"translation", {0.1, 0.2, 1.3}},
                           {"rotation", {rotation.x, rotation.y, rotation.z, rotation.w}}});
  room["scenes"][0]["nodes"] = {0, 1};
  return glb_container(room.dump(), "");
}

TEST_F(DescribedScene, IsTheSamePictureToTheBit) {
  write("kitchen.glb", room_with_rolled_camera());
  const auto render = [&](const std::string& output) {
    const ProgramResult result =
        succeeded(run({"render", path("kitchen.glb"), "-o", path(output), "--spp", "1"}));
    return result.errors;
  };
  render("before.exr");
  render("before.png");
  succeeded(describe());
  EXPECT_THAT(render("after.exr"), HasSubstr("as kitchen.toml beside it says"));
  render("after.png");
  const RgbImage before = read_film_image(path("before.exr")).color;
  const RgbImage after = read_film_image(path("after.exr")).color;
  EXPECT_EQ(after.width, 900);  // 720 times 1.25
  EXPECT_EQ(after.height, 720);
  EXPECT_TRUE(after.pixels == before.pixels);
  EXPECT_TRUE(read_file(path("after.png")) == read_file(path("before.png"))) << "as bright";
}

TEST_F(DescribedScene, HasTheCameraThatIsChosen) {
  write("kitchen.glb", room_with_rolled_camera());
  succeeded(describe());
  const std::string of_the_file = read_file(path("kitchen.toml"));
  EXPECT_THAT(of_the_file, AllOf(HasSubstr("roll_deg = -22.918"),
                                 HasSubstr("vertical_fov_deg = 40\naspect_ratio = 1.25\n")));
  succeeded(describe({"--force", "--head", "0,0"}));
  EXPECT_THAT(read_file(path("kitchen.toml")),
              AllOf(HasSubstr("vertical_fov_deg = 40"), Not(HasSubstr("roll_deg"))));
}

TEST_F(DescribedScene, MayHaveItsExtensionInCapitals) {
  write("K\"che.GLB", room_with({"Crate"}));
  const std::string file = path("K\"che.GLB");
  succeeded(run({"scene", "describe", file}));
  const ProgramResult render =
      succeeded(run({"render", file, "-o", path("x.png"), "--size", "16x8", "--spp", "1"}));
  EXPECT_THAT(render.errors, HasSubstr("is shown as K\"che.toml beside it says"));
}

TEST_F(DescribedScene, IsNotWrittenIfNobodyCouldReadIt) {
  const ProgramResult result =
      describe({"--environment", "1,1,1", "--environment-strength", "1e9"});
  expect_one_line(result, 1, "environment_strength is out of range");
  EXPECT_FALSE(std::filesystem::exists(path("kitchen.toml")));
  EXPECT_FALSE(std::filesystem::exists(path("kitchen-objects.png")));
  expect_one_line(run({"scene", "describe", ""}), 1, "no such file");
}

TEST_F(DescribedScene, ComesWithAPictureOfEachObject) {
  succeeded(describe({"--contact-sheet", path("sheet.png")}));
  const FilmImage sheet = read_film_image(path("sheet.png"));
  constexpr int gap = 8;
  constexpr int side = 192;
  constexpr int label = 20;
  EXPECT_EQ(sheet.color.width, 3 * gap + 2 * side);
  EXPECT_EQ(sheet.color.height, 2 * gap + side + label);
  const auto is_lit = [](const Rgb& pixel) { return pixel.g > 0.01F; };
  const auto row = [&](int y) { return sheet.color.pixels.begin() + y * sheet.color.width; };
  EXPECT_TRUE(std::any_of(row(gap + side / 2), row(gap + side / 2 + 1), is_lit));
  EXPECT_TRUE(std::any_of(row(gap + side), row(gap + side + label), is_lit)) << "the labels";
  EXPECT_FALSE(std::any_of(row(0), row(gap), is_lit));
}

TEST_F(DescribedScene, IsNotDescribedOverWhatIsThere) {
  write("kitchen.toml", "# mine\n");
  expect_one_line(describe(), 1, "kitchen.toml: is there already; add --force");
  EXPECT_EQ(read_file(path("kitchen.toml")), "# mine\n");
  succeeded(describe({"--force"}));
  EXPECT_THAT(read_file(path("kitchen.toml")), HasSubstr("Crate"));
}

TEST_F(DescribedScene, TakesOptionsAndOtherPlaces) {
  succeeded(describe({"-o", path("night.toml"), "--camera", "0,0,1", "--head", "5,-2",
                      "--environment", "0.1,0.1,0.2", "--light-units", "radiometric"}));
  EXPECT_THAT(
      read_file(path("night.toml")),
      AllOf(HasSubstr("position = [0, 0, 1]"), HasSubstr("azimuth_deg = 5"),
            HasSubstr("elevation_deg = -2"), HasSubstr("environment_radiance = [0.1, 0.1, 0.2]"),
            HasSubstr("light_units = \"radiometric\"")));
  succeeded(run({"scene", "info", path("night.toml")}));
  expect_one_line(describe({"-o", path("night.txt")}), 2, "ends in .toml");
}

TEST_F(DescribedScene, WithoutObjectsSaysHowToFindThem) {
  succeeded(describe());
  ASSERT_TRUE(std::filesystem::exists(path("kitchen-objects.png")));
  write("kitchen.glb", room_glb());
  const ProgramResult result = succeeded(describe({"--force"}));
  EXPECT_THAT(result.output, AllOf(HasSubstr("0 objects"), HasSubstr("foveola scene pick")));
  EXPECT_FALSE(std::filesystem::exists(path("kitchen-objects.png"))) << "of other objects";
}

}  // namespace
}  // namespace foveola::test
