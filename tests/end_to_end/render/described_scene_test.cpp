// A user's own scene, whose descriptor lies beside its file and beside the protocol of a study, and
// `foveola scene describe`, which writes one.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/files/files.h"
#include "renderer/glb/glb_document.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/hall.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

class OwnScene : public testing::Test {
 protected:
  OwnScene() {
    write("kitchen.glb", room_glb());
    write("kitchen.toml", descriptor("Stove"));
    write("study.toml",
          "name = \"cooking\"\ntitle = \"A study\"\nscenes = [\"kitchen\"]\n"
          "methods = [\"od\"]\n[timing]\nmark_timeout_s = 5\n" +
              std::string(small_tables));
  }

  static std::string descriptor(const std::string& object) {
    return "title = \"A kitchen\"\nfile = \"kitchen.glb\"\nexposure_stops = 1.5\n"
           "[camera]\nposition = [0, 1, 0]\nazimuth_deg = 0\nelevation_deg = 0\n"
           "[[object]]\nname = \"" +
           object + "\"\nposition = [0, 1, -1]\nradius_deg = 5\n";
  }

  void write(const std::string& name, const std::string& content) {
    folder_.write("mine/" + name, content);
  }
  std::string path(const std::string& name) const { return folder_ / ("mine/" + name); }

  ProgramResult run(const std::vector<std::string>& arguments) const {
    return run_foveola(arguments, {{"XDG_DATA_HOME", (folder_ / "data").string()},
                                   {"XDG_CACHE_HOME", (folder_ / "cache").string()}});
  }

  ProgramResult simulate() const {
    return run({"study", "simulate", path("study.toml"), "--db", path("study.sqlite"),
                "--participants", "1"});
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(OwnScene, AChangedDescriptorIsAnotherScene) {
  succeeded(simulate());
  write("kitchen.toml", descriptor("Fridge"));
  const ProgramResult refused = run({"study", "simulate", path("study.toml"), "--db",
                                     path("study.sqlite"), "--participants", "2"});
  expect_one_line(refused, 1, "kitchen");
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("Stove"), HasSubstr("Fridge")));
}

TEST_F(OwnScene, WithoutObjectsIsToldHowToGetThem) {
  write("kitchen.toml", "title = \"Not a descriptor\"\n");
  const ProgramResult result = run({"study", "check", path("study.toml")});
  expect_one_line(result, 1, "study.toml:3:11");
  EXPECT_THAT(result.errors, HasSubstr("foveola scene describe"));
}

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
  EXPECT_THAT(render("after.exr"), HasSubstr("with the settings of kitchen.toml beside it"));
  render("after.png");
  const RgbImage before = read_film_image(path("before.exr")).color;
  const RgbImage after = read_film_image(path("after.exr")).color;
  EXPECT_EQ(after.width, 900);  // 720 times 1.25
  EXPECT_EQ(after.height, 720);
  EXPECT_TRUE(after.pixels == before.pixels);
  EXPECT_TRUE(read_file(path("after.png")) == read_file(path("before.png"))) << "as bright";
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
  expect_one_line(describe(), 1, "kitchen.toml: exists already; add --force");
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
