// By what light the render command shows a scene, and how bright.
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "renderer/base/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/rendered_room.h"

namespace foveola::test {
namespace {

/// A cube of 2 m around the origin, its fronts outside.
constexpr const char* cube_obj =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\n";

TEST_F(Render, SaysWhereItStandsAndThatNothingShines) {
  const std::string cube = folder_.write("cube.obj", cube_obj).string();
  const auto render_cube = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", cube, "-o", (folder_ / "c.exr").string(), "--size",
                                     "64x32", "--spp", "1"});
    return run_foveola(options);
  };
  const ProgramResult dark = render_cube({});
  EXPECT_EQ(dark.exit_code, 0);
  EXPECT_THAT(dark.errors, testing::HasSubstr("nothing in the scene shines"));
  EXPECT_THAT(dark.errors, testing::HasSubstr("--environment 1,1,1"));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 1.0) << "but it is written";

  const ProgramResult lit = render_cube({"--environment", "1,1,1"});
  EXPECT_THAT(lit.errors, testing::Not(testing::HasSubstr("shines")));
  EXPECT_THAT(lit.errors,
              testing::HasSubstr("the file has no camera: it is seen from outside with all of it "
                                 "in the picture; that is --camera "));
  EXPECT_THAT(lit.errors,
              testing::HasSubstr(" --head -30,-20, where other places and angles can be given"));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 0.0);

  const ProgramResult inside = render_cube({"--environment", "1,1,1", "--camera", "0,0,0"});
  EXPECT_THAT(inside.errors, testing::Not(testing::HasSubstr("warning")));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 1.0);
}

TEST_F(Render, AnEmptyFileIsBlackButForAnEnvironment) {
  write_file(folder_ / "room.gltf", R"({"asset":{"version":"2.0"}})");
  const ProgramResult dark = render("a.exr", {"--size", "64x32", "--spp", "1"});
  EXPECT_EQ(dark.exit_code, 0);
  EXPECT_THAT(dark.errors, testing::HasSubstr("the scene has no triangles"));
  EXPECT_THAT(dark.errors, testing::HasSubstr("export its objects as meshes"));
  EXPECT_THAT(dark.errors, testing::HasSubstr("--environment 1,1,1"));
  ASSERT_EQ(render("a.exr", {"--size", "64x32", "--spp", "1", "--environment", "1,1,1"}).exit_code,
            0);
  EXPECT_EQ(black_share(read_film_image(folder_ / "a.exr").color), 0.0);
}

/// Of a constant environment of 0.125, two stops make 0.5, whose sRGB code is 188 (IEC 61966-2-1).
TEST_F(Render, ExposesPicturesAndLeavesRadiances) {
  write_file(folder_ / "room.gltf", R"({"asset":{"version":"2.0"}})");
  const auto pixel_of = [&](const std::string& output, const std::string& stops) {
    const ProgramResult result =
        render(output, {"--size", "64x32", "--spp", "1", "--environment", "0.125,0.125,0.125",
                        "--exposure", "fixed:" + stops});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_film_image(folder_ / output).color.pixels.front().g;
  };
  EXPECT_EQ(pixel_of("a.exr", "2"), 0.125F);
  EXPECT_NEAR(pixel_of("a.png", "2"), 0.5F, 0.003F);
  EXPECT_NEAR(pixel_of("a.png", "0"), 0.125F, 0.002F);
  EXPECT_EQ(render("a.png", {"--exposure", "fixed:41"}).exit_code, 2);
}

TEST_F(Render, LightsOfBlendersExportsAreInWatts) {
  const auto run = [&](const std::string& mode, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"render",   TEST_DATA_DIR "/blender/" + mode + ".gltf",
                                          "-o",       folder_ / "b.exr",
                                          "--size",   "64x32",
                                          "--spp",    "4",
                                          "--camera", "0,1,3"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_foveola(arguments);
  };
  const auto picture = [&] { return read_film_image(folder_ / "b.exr").color.pixels; };
  EXPECT_THAT(run("standard", {}).errors, testing::HasSubstr("divided by 683 lm/W"));
  const auto by_default = picture();
  EXPECT_EQ(run("unitless", {"--light-units", "radiometric"}).errors.find("683"),
            std::string::npos);
  EXPECT_EQ(picture(), by_default);
  EXPECT_EQ(run("standard", {"--light-units", "photometric"}).errors.find("683"),
            std::string::npos);
  EXPECT_EQ(picture(), by_default);
  run("standard", {"--light-units", "radiometric"});
  EXPECT_NE(picture(), by_default);
}

TEST_F(Render, AConstantEnvironmentFillsTheSkyOfAnOpenScene) {
  const std::string lamp_only = R"({"asset":{"version":"2.0"}})";
  write_file(folder_ / "empty.gltf", lamp_only);
  const ProgramResult result = run_foveola({"render", (folder_ / "empty.gltf").string(), "-o",
                                            (folder_ / "sky.exr").string(), "--size", "16x8",
                                            "--spp", "1", "--environment", "0.25,0.5,2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(read_film_image(folder_ / "sky.exr").color.pixels,
              testing::Each(Rgb(0.25F, 0.5F, 2.0F)));
}

// Not at the strength of the scene's own, which its descriptor gives.
TEST_F(Render, AnotherEnvironmentShinesAsItIsGiven) {
  const std::string image = (folder_ / "court.exr").string();
  const ProgramResult result =
      run_foveola({"render", "arcade", "-o", image, "--panorama", "--size", "64x32", "--spp", "1",
                   "--max-depth", "1", "--environment", "7,7,7"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(read_film_image(image).color.pixels, testing::Contains(Rgb(7.0F)));
}

}  // namespace
}  // namespace foveola::test
