// By what light the render command shows a scene, and how bright.
#include <string>
#include <vector>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// A cube of 2 m around the origin, its fronts outside.
constexpr const char* cube_obj =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\n";

TEST_F(Render, SaysWhereItStandsAndThatNothingShines) {
  const std::string cube = folder_.write("cube.obj", cube_obj).string();
  const auto render_cube = [&](const std::vector<std::string>& options) {
    return run_foveola(joined(
        {"render", cube, "-o", (folder_ / "c.exr").string(), "--size", "64x32", "--spp", "1"},
        options));
  };
  const ProgramResult dark = succeeded(render_cube({}));
  EXPECT_THAT(dark.errors, HasSubstr("nothing in the scene emits light"));
  EXPECT_THAT(dark.errors, HasSubstr("--environment 1,1,1"));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 1.0) << "but it is written";

  const ProgramResult lit = render_cube({"--environment", "1,1,1"});
  EXPECT_THAT(lit.errors, Not(HasSubstr("shines")));
  EXPECT_THAT(lit.errors,
              HasSubstr("the file has no camera: it is seen from outside with all of it "
                        "in the picture; that is --camera "));
  EXPECT_THAT(lit.errors, HasSubstr(" --head -30,-20, where other places and angles can be given"));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 0.0);

  const ProgramResult inside = render_cube({"--environment", "1,1,1", "--camera", "0,0,0"});
  EXPECT_THAT(inside.errors, Not(HasSubstr("warning")));
  EXPECT_EQ(black_share(read_film_image(folder_ / "c.exr").color), 1.0);
}

/// Of a constant environment of 0.125, two stops make 0.5, whose sRGB code is 188 (IEC 61966-2-1).
TEST_F(Render, ExposesPicturesAndLeavesRadiances) {
  write_file(folder_ / "room.gltf", R"({"asset":{"version":"2.0"}})");
  const auto pixel_of = [&](const std::string& output, const std::string& stops) {
    succeeded(render(output, {"--size", "64x32", "--spp", "1", "--environment", "0.125,0.125,0.125",
                              "--exposure", "fixed:" + stops}));
    return read_film_image(folder_ / output).color.pixels.front().g;
  };
  EXPECT_EQ(pixel_of("a.exr", "2"), 0.125F);
  EXPECT_NEAR(pixel_of("a.png", "2"), 0.5F, 0.003F);
  EXPECT_NEAR(pixel_of("a.png", "0"), 0.125F, 0.002F);
  EXPECT_EQ(render("a.png", {"--exposure", "fixed:41"}).exit_code, 2);
}

// Not at the strength of the scene's own, which its descriptor gives.
TEST_F(Render, AnotherEnvironmentShinesAsItIsGiven) {
  const std::string image = (folder_ / "court.exr").string();
  succeeded(run_foveola({"render", "arcade", "-o", image, "--panorama", "--size", "64x32", "--spp",
                         "1", "--max-depth", "1", "--environment", "7,7,7"}));
  EXPECT_THAT(read_film_image(image).color.pixels, Contains(Rgb(7.0F)));
}

}  // namespace
}  // namespace foveola::test
