#include <limits>
#include <memory>

#include <gmock/gmock.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/load_scene.h"
#include "tests/encoded_image.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class LoadEnvironment : public InTemporaryFolder {
 protected:
  std::filesystem::path write_floats(const std::string& name, int width, int height, int channels,
                                     const std::vector<float>& values, int tile_side = 0) const {
    const std::string format =
        std::filesystem::path(name).extension() == ".hdr" ? "hdr" : "openexr";
    return write(name, encoded_image({.format = format,
                                      .width = width,
                                      .height = height,
                                      .channels = channels,
                                      .samples = values,
                                      .tile_side = tile_side}));
  }

  /// Loads it without a warning.
  static Environment load(const std::filesystem::path& path) {
    Warnings warnings;
    Environment environment = load_environment(path, warnings);
    EXPECT_THAT(warnings.lines(), IsEmpty());
    return environment;
  }

  static std::string error_of(const std::filesystem::path& path) {
    try {
      load(path);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(LoadEnvironment, ReadsFloatsAsTheyAre) {
  const Environment environment =
      load(write_floats("sky.exr", 2, 2, 3, {0, 1, 2, 3, 4, 5, 600, 7, 8, 9, 10, 0.125F}));
  EXPECT_EQ(environment.radiance, Rgb(1.0F));
  EXPECT_EQ(environment.map_width, 2);
  EXPECT_EQ(environment.map_height, 2);
  EXPECT_THAT(environment.map,
              ElementsAre(Rgb(0, 1, 2), Rgb(3, 4, 5), Rgb(600, 7, 8), Rgb(9, 10, 0.125F)));
}

TEST_F(LoadEnvironment, ReadsRadianceHdr) {
  const Environment environment = load(write_floats("sky.hdr", 1, 1, 3, {1.0F, 0.5F, 0.25F}));
  EXPECT_THAT(environment.map, ElementsAre(Rgb(1.0F, 0.5F, 0.25F)));
}

TEST_F(LoadEnvironment, WhatIsNotLightIsDarkAndCounted) {
  Warnings warnings;
  const Environment environment = load_environment(
      write_floats("sky.exr", 3, 1, 3, {nan, 1, -5, 7, 2, -infinity, -0.0F, 0, 3}), warnings);
  EXPECT_THAT(environment.map, ElementsAre(Rgb(0, 1, 0), Rgb(7, 2, 0), Rgb(0, 0, 3)));
  EXPECT_THAT(warnings.lines(), ElementsAre("pixels of the environment that are negative or no "
                                            "number are black (2 in sky.exr)"));
}

/// Half floats end at 65504: a sun in such a file is often infinite.
TEST_F(LoadEnvironment, InfiniteLightIsLimitedAndCounted) {
  Warnings warnings;
  const std::filesystem::path dim = write_floats("sky.exr", 2, 1, 3, {1, infinity, 3, 4, 5, 6});
  EXPECT_THAT(load_environment(dim, warnings).map, ElementsAre(Rgb(1, 65504, 3), Rgb(4, 5, 6)));
  EXPECT_THAT(
      warnings.lines(),
      ElementsAre("infinite pixels of the environment are limited to 65504 (1 in sky.exr)"));
  const std::filesystem::path bright =
      write_floats("sun.exr", 2, 1, 3, {infinity, infinity, nan, 1, 2, 1e6F});
  EXPECT_THAT(load_environment(bright, warnings).map,
              ElementsAre(Rgb(1e6F, 1e6F, 0), Rgb(1, 2, 1e6F)));
}

TEST_F(LoadEnvironment, EightBitsAreSrgb) {
  const Environment environment =
      load(write("sky.png", png(2, 1, 3, std::vector<std::uint8_t>{188, 0, 255, 10, 10, 10})));
  EXPECT_NEAR(environment.map[0].r, 0.502886F, 1e-5F);
  EXPECT_EQ(environment.map[0].g, 0.0F);
  EXPECT_EQ(environment.map[0].b, 1.0F);
  EXPECT_NEAR(environment.map[1].r, 10.0F / 255.0F / 12.92F, 1e-7F);
}

TEST_F(LoadEnvironment, GreyAndAlphaAreSpreadAndDropped) {
  EXPECT_THAT(load(write_floats("grey.exr", 1, 1, 1, {7})).map, ElementsAre(Rgb(7.0F)));
  EXPECT_THAT(load(write_floats("alpha.exr", 1, 1, 4, {1, 2, 3, 0.5F})).map,
              ElementsAre(Rgb(1, 2, 3)));
}

TEST_F(LoadEnvironment, RefusesWhatIsNoImage) {
  EXPECT_THAT(error_of(folder() / "gone.exr"), HasSubstr("gone.exr: no such file"));
  EXPECT_THAT(error_of(folder()), HasSubstr("not a file"));
  EXPECT_THAT(error_of(write("text.exr", "this is no image")),
              HasSubstr("text.exr: is no EXR, HDR, PNG or JPEG image"));
  EXPECT_THAT(error_of(write("empty.png", "")), HasSubstr("empty.png: "));
  const std::string whole =
      read_file(write_floats("whole.exr", 4, 4, 3, std::vector<float>(48, 1)));
  EXPECT_THAT(error_of(write("cut.exr", whole.substr(0, whole.size() - 20))),
              HasSubstr("cut.exr: is damaged"));
}

/// Before memory is taken: 16384 x 8192 pixels would be 1.5 GiB.
TEST_F(LoadEnvironment, RefusesSmallFilesThatAskForMuchMemory) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 16384\n";
  EXPECT_THAT(error_of(write("huge.hdr", header)),
              HasSubstr("huge.hdr: is damaged: 52 bytes cannot hold 16384 x 8192 pixels"));
  std::string palette = png(1, 1, 3, std::vector<std::uint8_t>{1, 2, 3});
  palette.replace(16, 8, std::string("\0\0\x40\0\0\0\x20\0", 8));
  palette.replace(29, 4, "\xAD\x1C\xCB\x36");
  palette.append(100000, '\0');
  EXPECT_THAT(error_of(write("huge.png", palette)),
              HasSubstr("huge.png: would take 1536 MiB of memory, more than 256 and"));
}

TEST_F(LoadEnvironment, RefusesTilesThatAskForMuchMemory) {
  const std::filesystem::path file =
      write_floats("tiled.exr", 16, 16, 3, std::vector<float>(std::size_t{3} * 16 * 16, 1), 16);
  EXPECT_EQ(load(file).map_width, 16);
  std::string bytes = read_file(file);
  const std::string attribute("tiles\0tiledesc\0\x09\0\0\0", 19);
  const std::size_t place = bytes.find(attribute);
  ASSERT_NE(place, std::string::npos);
  bytes.replace(place + attribute.size(), 8, std::string("\0\x30\0\0\0\x30\0\0", 8));
  EXPECT_THAT(error_of(write("huge.exr", bytes)),
              HasSubstr("huge.exr: would take 1728 MiB of memory, more than 256"));
}

TEST_F(LoadEnvironment, ReadsWhatIsCompressedAsFarAsCanBe) {
  const int width = 8192;
  const std::filesystem::path white = write_floats(
      "white.exr", width, width / 2, 3, std::vector<float>(std::size_t{3} * width * width / 2, 1));
  EXPECT_EQ(load(white).map_width, width);
}

}  // namespace
}  // namespace foveola::test
