// The render command as a user types it.
#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/files.h"
#include "renderer/image/image_file.h"
#include "renderer/view/equirect.h"
#include "renderer/view/viewport.h"
#include "tests/end_to_end/program.h"

namespace foveola::test {
namespace {

class Render : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }

  ProgramResult render(const std::string& output, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"render", (folder_ / "room.gltf").string(), "-o",
                                          (folder_ / output).string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_foveola(arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(Render, ReportsWhatItDidAsJson) {
  const ProgramResult result =
      render("a.exr", {"--size", "64x32", "--spp", "4", "--seed", "3", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json report = nlohmann::json::parse(result.output);
  EXPECT_EQ(report.at("samples"), 64 * 32 * 4);
  EXPECT_EQ(report.at("non_finite"), 0);
  EXPECT_GT(report.at("seconds"), 0.0);
  EXPECT_GT(report.at("samples_per_second"), 0.0);
  EXPECT_GE(report.at("rays"), 64 * 32 * 4);
  EXPECT_GT(report.at("peak_memory_bytes"), 0);
  EXPECT_GT(report.at("load_seconds"), 0.0);
  EXPECT_GT(report.at("build_seconds"), 0.0);
}

TEST_F(Render, OdGivesEveryPixelItsSamples) {
  ASSERT_EQ(render("a.exr", {"--panorama", "--size", "64x32", "--spp", "4"}).exit_code, 0);
  const FilmImage image = read_film_image(folder_ / "a.exr");
  ASSERT_EQ(image.color.width, 64);
  ASSERT_EQ(image.color.height, 32);
  EXPECT_THAT(image.samples, testing::Each(4U));
  for (const Rgb& pixel : image.color.pixels) {
    EXPECT_TRUE(is_finite(pixel));
    EXPECT_GT(luminance(pixel), 0.0F);
  }
}

TEST_F(Render, KeepsVariancesAndSaysInTheFileWhatItDid) {
  ASSERT_EQ(render("a.exr", {"--size", "64x32", "--samples", "3000", "--method", "fv:cutoff=70",
                             "--seed", "11", "--gaze", "20,-5", "--variance", "--clamp", "7.5",
                             "--environment", "0.25,0.5,0.75"})
                .exit_code,
            0);
  const FilmImage image = read_film_image(folder_ / "a.exr");
  ASSERT_EQ(image.variances.size(), 64U * 32U);
  double sum = 0.0;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    if (image.samples[i] < 2) {
      EXPECT_EQ(image.variances[i], 0.0F);
    }
    sum += image.variances[i];
  }
  EXPECT_GT(sum, 0.0);
  const std::string bytes = read_file(folder_ / "a.exr");
  for (const char* fact : {"foveola:method", "fv:cutoff=70", "foveola:seed", "foveola:gaze_deg",
                           "20,-5", "foveola:head_deg", "room.gltf", "foveola:clamp", "7.5",
                           "foveola:environment", "0.25,0.5,0.75", "foveola:camera_m"}) {
    EXPECT_THAT(bytes, testing::HasSubstr(fact));
  }
  ASSERT_EQ(render("b.exr", {"--size", "64x32", "--samples", "3000"}).exit_code, 0);
  EXPECT_TRUE(read_film_image(folder_ / "b.exr").variances.empty());
}

/// The fraction of an image's pixels that are black.
double black_share(const RgbImage& image) {
  const auto black = std::count(image.pixels.begin(), image.pixels.end(), Rgb(0.0F));
  return static_cast<double>(black) / static_cast<double>(image.pixels.size());
}

TEST_F(Render, WritesWhatTheDisplayShows) {
  const auto view = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {
        "--size",      "512x256", "--samples", "3000", "--view", (folder_ / "v.exr").string(),
        "--view-size", "80x40",   "--head",    "30,10"};
    options.insert(options.end(), more.begin(), more.end());
    const ProgramResult result = render("a.exr", options);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_film_image(folder_ / "v.exr").color;
  };
  const RgbImage plain = view({});
  EXPECT_EQ(plain.width, 80);
  EXPECT_EQ(plain.height, 40);
  EXPECT_GT(black_share(plain), 0.3);
  EXPECT_EQ(black_share(view({"--fill-unsampled"})), 0.0);
  EXPECT_NE(view({"--lens", "0.5,0.5,0.3,0.1"}).pixels, plain.pixels);
}

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
  EXPECT_THAT(lit.errors, testing::HasSubstr(" --head -30,-20, and others look from elsewhere"));
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

// All samples of a view of 60 x 30 degrees lie within 15 degrees of the horizon, a pixel's height
// aside, and some near its edges.
TEST_F(Render, AViewHasTwoFieldsOfView) {
  ASSERT_EQ(render("a.exr", {"--size", "128x64", "--samples", "20000", "--method", "vp", "--head",
                             "0,0", "--fov", "60x30"})
                .exit_code,
            0);
  const FilmImage image = read_film_image(folder_ / "a.exr");
  const auto row_has_samples = [&](int y) {
    return std::any_of(image.samples.begin() + y * 128, image.samples.begin() + (y + 1) * 128,
                       [](std::uint32_t count) { return count > 0; });
  };
  // Rows are 2.8125 degrees high: 15 degrees above the horizon is in row 32 - 6 = 26.
  EXPECT_TRUE(row_has_samples(26));
  EXPECT_FALSE(row_has_samples(25));
  EXPECT_FALSE(row_has_samples(38));
  EXPECT_EQ(run_foveola({"render", (folder_ / "room.gltf").string(), "-o",
                         (folder_ / "b.exr").string(), "--fov", "60x180"})
                .exit_code,
            2);
  EXPECT_EQ(run_foveola({"render", (folder_ / "room.gltf").string(), "-o",
                         (folder_ / "b.exr").string(), "--lens", "0.5,0.5,-5,0"})
                .exit_code,
            2);
}

// 2^23 samples over Reddy's 1091.85 square degrees (the paper's normaliser) in the fovea.
TEST(BenchSampling, CountsWhereSamplesFall) {
  const ProgramResult result = run_foveola({"bench", "sampling", "--density", "fv", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json rings = nlohmann::json::parse(result.output).at("rings");
  const nlohmann::json& ring = rings.at(1);
  EXPECT_EQ(ring.at("to_deg"), 1.0);
  EXPECT_NEAR(ring.at("samples_per_square_degree").get<double>(), 8388608.0 / 1091.85, 76.0);
  EXPECT_NEAR(ring.at("stated_per_square_degree").get<double>(), 8388608.0 / 1091.85, 2.0);
}

TEST_F(Render, FvSamplesFollowTheGazeAndVpSamplesStayInTheView) {
  const std::vector<std::string> options = {"--size", "128x64", "--samples", "100000",
                                            "--head", "170,0",  "--gaze",    "-175,20",
                                            "--fov",  "60",     "--method"};
  const Vec3 gaze =
      direction_from({.azimuth_rad = radians(-175.0), .elevation_rad = radians(20.0)});
  const Viewport view(head_orientation({.azimuth_rad = radians(170.0), .elevation_rad = 0.0}),
                      radians(64.0),
                      radians(64.0));  // one pixel more on each side
  for (const std::string method : {"fv", "vp"}) {
    std::vector<std::string> arguments = options;
    arguments.push_back(method);
    ASSERT_EQ(render(method + ".exr", arguments).exit_code, 0);
    const FilmImage image = read_film_image(folder_ / (method + ".exr"));
    std::uint64_t total = 0;
    std::uint64_t expected_place = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 128; ++x) {
        const Vec3 direction = direction_from_equirect({(x + 0.5) / 128.0, (y + 0.5) / 64.0});
        const std::uint32_t count = image.samples[static_cast<std::size_t>(y) * 128 + x];
        total += count;
        const bool inside = method == "fv" ? degrees(angle_between(direction, gaze)) < 20.0
                                           : view.project(direction).has_value();
        expected_place += inside ? count : 0;
      }
    }
    EXPECT_EQ(total, 100000U);
    // Of the density 2 pi e m(e), 480.00 of 1091.85 lie within 20 degrees (trapezoid rule).
    const double fraction = static_cast<double>(expected_place) / static_cast<double>(total);
    if (method == "fv") {
      EXPECT_NEAR(fraction, 480.00 / 1091.85, 0.03);
    } else {
      EXPECT_EQ(fraction, 1.0);
    }
  }
}

TEST_F(Render, TheImageDependsOnTheSeedAndNotOnTheThreads) {
  const std::vector<std::string> options = {"--size", "64x32", "--spp", "2", "--method", "fv"};
  const auto image = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(render(name, arguments).exit_code, 0);
    return read_film_image(folder_ / name).color.pixels;
  };
  const std::vector<Rgb> one = image("1.exr", {"--threads", "1"});
  EXPECT_TRUE(one == image("2.exr", {"--threads", "2"}));
  EXPECT_TRUE(one == image("4.exr", {"--threads", "4"}));
  EXPECT_FALSE(one == image("s.exr", {"--seed", "1"}));
}

TEST_F(Render, SecondsBoundTheTime) {
  const ProgramResult result =
      render("a.png", {"--size", "64x32", "--seconds", "0.2", "--json", "--max-depth", "1"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_GE(nlohmann::json::parse(result.output).at("seconds"), 0.2);
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

TEST_F(Render, CompareFindsNoErrorBetweenAnImageAndItself) {
  ASSERT_EQ(render("a.exr", {"--size", "32x16", "--spp", "1"}).exit_code, 0);
  const std::string image = (folder_ / "a.exr").string();
  const ProgramResult result = run_foveola({"compare", image, image, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json metrics = nlohmann::json::parse(result.output);
  EXPECT_EQ(metrics.at("rmse"), 0.0);
  EXPECT_EQ(metrics.at("pixels"), 32 * 16);
}

/// A row for each scene: all around at the left, the view at the right, a white gap between.
TEST_F(Render, SheetShowsScenesBelowEachOther) {
  nlohmann::json with_camera = nlohmann::json::parse(room_gltf());
  with_camera["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  with_camera["nodes"][0]["camera"] = 0;
  write_file(folder_ / "room.gltf", with_camera.dump());
  const std::string room = (folder_ / "room.gltf").string();
  const ProgramResult result =
      run_foveola({"scene", "sheet", room, room, "-o", (folder_ / "sheet.exr").string(), "--size",
                   "64x32", "--spp", "64", "--exposure", "fixed:0"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  ASSERT_EQ(render("all.exr", {"--panorama", "--size", "64x32", "--spp", "64"}).exit_code, 0);
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
    const ProgramResult result = run_foveola({"scene", "pick", (folder_ / "room.gltf").string(),
                                              "--camera", camera, "--gaze", gaze, "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
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

TEST(Bench, TracingIsMeasuredAgainstEmbreeAlone) {
  const ProgramResult result =
      run_foveola({"bench", "tracing", "studio-car", "--paths", "20000", "--repetitions", "6",
                   "--threads", "1,2", "--size", "256x128", "--no-fast-path", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["runs"].size(), 2U);
  for (const auto& run : json["runs"]) {
    EXPECT_GT(run["general_path"]["gain"]["median"], 0.0);
    EXPECT_LT(run["general_path"]["share_of_pixels_that_differ"], 0.1);
    EXPECT_NEAR(run["general_path"]["relative_mean"], 1.0, 0.01);
    EXPECT_EQ(run["rays"], json["runs"][0]["rays"]);
    EXPECT_GE(run["rays"]["primary"], 20000);
    EXPECT_GT(run["rays_per_second"]["shadow"], 0.0);
    for (const char* figure :
         {"seconds", "paths_per_second", "embree_seconds", "ratio_to_embree"}) {
      const auto& median = run[figure];
      EXPECT_GT(median["low"], 0.0) << figure;
      EXPECT_LE(median["low"], median["median"]) << figure;
      EXPECT_LE(median["median"], median["high"]) << figure;
    }
    for (const char* kind : {"primary", "bounce", "shadow"}) {
      EXPECT_EQ(run["embree"][kind]["seconds"].size(), 5U) << kind;
      EXPECT_TRUE(run["embree"][kind]["seconds"].contains(run["embree"][kind]["fastest"])) << kind;
    }
  }
}

TEST(Bench, SamplingMeasuresEveryMethodAskedFor) {
  const ProgramResult result = run_foveola({"bench", "sampling", "od", "fv:cutoff=40", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json figures = nlohmann::json::parse(result.output).at("figures");
  ASSERT_EQ(figures.size(), 8U);  // six of the film
  EXPECT_EQ(figures[1].at("name"), "fv:cutoff=40");
  for (const nlohmann::json& figure : figures) {
    EXPECT_GT(figure.at("median"), 0.0);
  }
}

}  // namespace
}  // namespace foveola::test
