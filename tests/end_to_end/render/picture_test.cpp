// Pictures by render, as a user who knows other renderers expects them.
#include <csignal>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/running_program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

using Json = nlohmann::json;

/// The room with two cameras in it: one looks at the back wall, one up at the lamp.
Json room_with_cameras() {
  Json room = Json::parse(room_gltf());
  const double quarter = 0.70710678118654752;
  room["cameras"] = {
      {{"type", "perspective"},
       {"name", "Ahead"},
       {"perspective", {{"yfov", 0.8}, {"aspectRatio", 2.0}, {"znear", 0.1}}}},
      {{"type", "perspective"}, {"name", "Up"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  room["nodes"].push_back({{"camera", 0}, {"translation", {0.25, 0.5, 1}}});
  room["nodes"].push_back({{"camera", 1}, {"rotation", {quarter, 0, 0, quarter}}});
  room["scenes"][0]["nodes"] = {0, 1, 2};
  return room;
}

class RenderPicture : public testing::Test {
 protected:
  void SetUp() override { write_room(room_with_cameras()); }

  void write_room(const Json& room) { write_file(folder_ / "room.gltf", room.dump()); }

  ProgramResult render(const std::string& output, const std::vector<std::string>& options) {
    return run_foveola(joined(
        {"render", (folder_ / "room.gltf").string(), "-o", (folder_ / output).string()}, options));
  }

  Json report(const std::string& output, std::vector<std::string> options) {
    options.emplace_back("--json");
    const ProgramResult result = succeeded(render(output, options));
    return Json::parse(result.output);
  }

  std::vector<Rgb> pixels(const std::string& output, const std::vector<std::string>& options) {
    succeeded(render(output, options));
    return read_film_image(folder_ / output).color.pixels;
  }

  TemporaryFolder folder_;
};

TEST_F(RenderPicture, IsThatOfTheFilesFirstCamera) {
  const Json json = report("a.exr", {"--spp", "0.1", "--max-depth", "1"});
  EXPECT_EQ(json.at("projection"), "perspective");
  EXPECT_EQ(json.at("width"), 1280);
  EXPECT_EQ(json.at("height"), 640);
  EXPECT_NEAR(json.at("fov_deg")[1], 0.8 * 180.0 / 3.14159265358979, 1e-6);
  EXPECT_NEAR(json.at("camera")[0], 0.25, 1e-6);
  EXPECT_NEAR(json.at("samples_per_pixel"), 0.1, 1e-6);
  const IVec2 size = image_size(folder_ / "a.exr");
  EXPECT_EQ(size, IVec2(1280, 640));
  const std::string bytes = read_file(folder_ / "a.exr");
  for (const char* fact : {"foveola:projection", "perspective", "foveola:fov_deg",
                           "foveola:camera_m", "foveola:head_deg"}) {
    EXPECT_THAT(bytes, HasSubstr(fact));
  }
}

TEST_F(RenderPicture, IsThatOfAnotherCameraByItsName) {
  const Json up = report("a.exr", {"--camera", "Up", "--size", "64x64", "--spp", "1"});
  EXPECT_NEAR(up.at("head_deg")[1], 90.0, 1e-3);
  const RgbImage picture = read_film_image(folder_ / "a.exr").color;
  EXPECT_GT(picture.at(32, 32).g, 9.0F) << "the lamp shines with 10 overhead";
  expect_one_line(render("b.exr", {"--camera", "Down"}), 2,
                  "the file has no camera 'Down'; it has 'Ahead', 'Up'; or give a place");
}

/// A ray's share of the plane: at an angle a off the middle of a picture that shows 90 degrees, tan
/// a half pictures off.
TEST_F(RenderPicture, IsFlat) {
  const std::vector<Rgb> picture =
      pixels("a.exr", {"--camera", "0,0,0", "--head", "0,90", "--fov", "90", "--size", "256x256",
                       "--spp", "1", "--max-depth", "1"});
  // The lamp, 1.9 m above, reaches 0.5 m to each side: 0.5 / 1.9 of the half picture.
  int across = 0;
  for (std::size_t x = 0; x < 256; ++x) {
    across += picture[128 * 256 + x].g > 9.0F ? 1 : 0;
  }
  EXPECT_NEAR(across, 256.0 * 0.5 / 1.9, 1.5);
}

TEST_F(RenderPicture, APathOfItIsTracedAgain) {
  const std::vector<std::string> options = {"--size", "64x32", "--spp", "1"};
  const std::vector<Rgb> picture = pixels("a.exr", options);
  std::vector<std::string> replay = joined(options, {"--replay", "20,10,0", "--json"});
  const ProgramResult result = succeeded(render("b.exr", replay));
  EXPECT_EQ(Json::parse(result.output).at("radiance")[1], picture[10 * 64 + 20].g);
  replay[replay.size() - 2] = "64,10,0";
  EXPECT_EQ(render("b.exr", replay).exit_code, 2);
}

TEST_F(RenderPicture, A360DegreeImageIsMadeByNameOrByWhatOnlyThatHas) {
  const std::vector<Rgb> named = pixels("a.exr", {"--panorama", "--size", "64x32", "--spp", "2"});
  EXPECT_EQ(named, pixels("b.exr", {"--method", "od", "--size", "64x32", "--spp", "2"}));
  EXPECT_NE(named, pixels("c.exr", {"--size", "64x32", "--spp", "2"}));
  EXPECT_EQ(report("a.exr", {"--gaze", "0,0", "--size", "64x32", "--spp", "1"}).at("projection"),
            "equirectangular");
  EXPECT_EQ(report("a.exr", {"--adaptive", "0.1", "--size", "64x32"}).at("width"), 64);
}

TEST_F(RenderPicture, InterruptedItKeepsWhatThereIs) {
  const std::string output = folder_ / "a.exr";
  RunningProgram program({"render", (folder_ / "room.gltf").string(), "-o", output, "--size",
                          "64x32", "--spp", "20000", "--max-depth", "1"});
  program.wait_for("samples per pixel");
  program.kill(SIGINT);
  EXPECT_EQ(program.wait_for_end(), 130);
  EXPECT_THAT(program.said(), HasSubstr("stopped early"));
  const FilmImage image = read_film_image(output);
  EXPECT_THAT(image.samples, Each(testing::Gt(0U)));
}

TEST_F(RenderPicture, InfoListsCamerasAndLights) {
  Json room = room_with_cameras();
  room["extensionsUsed"].push_back("KHR_lights_punctual");
  room["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 3}},
                                                         {{"type", "directional"}}};
  room["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  room["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  room["scenes"][0]["nodes"].push_back(3);
  write_room(room);
  const std::string file = folder_ / "room.gltf";
  const ProgramResult text = run_foveola({"scene", "info", file});
  EXPECT_THAT(text.output, HasSubstr("camera     'Ahead' at 0.25,0.5,1 towards 0,0"));
  EXPECT_THAT(text.output, HasSubstr("camera     'Up'"));
  EXPECT_THAT(text.output, HasSubstr("1 point in W/sr, 1 directional in W/m^2"));
  const Json json = Json::parse(run_foveola({"scene", "info", file, "--json"}).output);
  EXPECT_EQ(json.at("cameras").at(0).at("name"), "Ahead");
  EXPECT_NEAR(json.at("cameras").at(0).at("vertical_fov_deg"), 45.8366, 1e-3);
  EXPECT_EQ(json.at("cameras").at(0).at("aspect_ratio"), 2.0);
  EXPECT_EQ(json.at("cameras").at(1).at("aspect_ratio"), nullptr);
  EXPECT_EQ(json.at("light_kinds").at(1).at("kind"), "directional");
}

TEST_F(RenderPicture, AClipIsChosenByTheNameThatInfoLists) {
  write_file(folder_ / "room.gltf", read_file(TEST_DATA_DIR "/gltf/two_clips.gltf"));
  const std::string file = folder_ / "room.gltf";
  EXPECT_THAT(run_foveola({"scene", "info", file}).output, HasSubstr("clip       'Run'\n"));
  const Json json = Json::parse(run_foveola({"scene", "info", file, "--json"}).output);
  EXPECT_THAT(json.at("clips"), ElementsAre("Idle", "Run"));
  const auto covered = [&](const std::string& clip) {
    return pixels("a.exr", {"--time", "1", "--clip", clip, "--camera", "5,0,2", "--head", "0,0",
                            "--size", "8x8", "--spp", "1"})[36]
        .g;
  };
  EXPECT_NEAR(covered("Run"), 1.0F, 1e-5F) << "five to the right";
  EXPECT_EQ(covered("Idle"), 0.0F);
  EXPECT_EQ(render("b.exr", {"--clip", "Run"}).exit_code, 2) << "a clip needs its time";
}

}  // namespace
}  // namespace foveola::test
