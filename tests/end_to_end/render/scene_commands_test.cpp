// The commands that show what is in a scene.
#include <string>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/base/vec.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// A row for each scene: all around at the left, the view at the right, a white gap between.
TEST_F(Render, SheetShowsScenesBelowEachOther) {
  nlohmann::json with_camera = nlohmann::json::parse(room_gltf());
  with_camera["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  with_camera["nodes"][0]["camera"] = 0;
  write_file(folder_ / "room.gltf", with_camera.dump());
  const std::string room = (folder_ / "room.gltf").string();
  succeeded(run_foveola({"scene", "sheet", room, room, "-o", (folder_ / "sheet.exr").string(),
                         "--size", "64x32", "--spp", "64", "--exposure", "fixed:0"}));
  succeeded(render("all.exr", {"--panorama", "--size", "64x32", "--spp", "64"}));
  const RgbImage sheet = read_film_image(folder_ / "sheet.exr").color;
  const RgbImage all = read_film_image(folder_ / "all.exr").color;
  ASSERT_EQ(sheet.width, 64 + 8 + 32);
  ASSERT_EQ(sheet.height, 32 + 8 + 32);
  EXPECT_EQ(sheet.at(10, 20), all.at(10, 20));
  EXPECT_EQ(sheet.at(10, 60), all.at(10, 20));
  EXPECT_EQ(sheet.at(68, 20), Rgb(1.0F));
  EXPECT_EQ(sheet.at(10, 36), Rgb(1.0F));
  // The middle of the view is the middle of the image around.
  EXPECT_NEAR(luminance(sheet.at(72 + 16, 16)), luminance(all.at(32, 16)),
              0.2F * luminance(all.at(32, 16)));
  EXPECT_GT(luminance(sheet.at(72, 0)), 0.0F);
  EXPECT_GT(luminance(sheet.at(72 + 31, 40 + 31)), 0.0F);
}

TEST_F(Render, PickTellsWhatTheGazeMeets) {
  const auto pick = [&](const std::string& camera, const std::string& gaze) {
    const ProgramResult result =
        succeeded(run_foveola({"scene", "pick", (folder_ / "room.gltf").string(), "--camera",
                               camera, "--gaze", gaze, "--json"}));
    return nlohmann::json::parse(result.output);
  };
  const nlohmann::json lamp = pick("0.2,0,0.1", "0,90");
  EXPECT_EQ(lamp.at("material"), "lamp");
  EXPECT_NEAR(lamp.at("distance_m"), 1.9, 1e-5);
  EXPECT_NEAR(lamp.at("position")[0], 0.2, 1e-5);
  EXPECT_NEAR(lamp.at("position")[1], 1.9, 1e-5);
  const nlohmann::json wall = pick("0,0,0", "90,0");
  EXPECT_EQ(wall.at("material"), "wall");
  EXPECT_NEAR(wall.at("position")[0], 2.0, 1e-5);
  EXPECT_EQ(pick("9,0,0", "90,0"), nullptr);
}

TEST_F(Render, InfoOfAFileWhoseNameIsNoUnicodeIsJson) {
  const std::string file = folder_.write("r\xffm.gltf", room_gltf()).string();
  const ProgramResult result = succeeded(run_foveola({"scene", "info", file, "--json"}));
  EXPECT_THAT(nlohmann::json::parse(result.output).at("title"), "r\uFFFDm");
}

}  // namespace
}  // namespace foveola::test
