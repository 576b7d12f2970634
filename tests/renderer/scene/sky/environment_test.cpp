#include "renderer/scene/environment.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/encoded_image.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

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
    return test::error_of([&] { load(path); });
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
  EXPECT_THAT(warnings.lines(),
              ElementsAre("negative or NaN pixels of the environment are black (2 in sky.exr)"));
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

std::filesystem::path picture_file(const std::string& name) {
  return std::filesystem::path(TEST_DATA_DIR) / "pictures" / name;
}

/// OpenEXR: pixels outside of the data window are black.
TEST_F(LoadEnvironment, APartOfThePictureStandsWhereTheFileSays) {
  const Environment whole = load(picture_file("env_full.exr"));
  const Environment part = load(picture_file("env_crop.exr"));
  EXPECT_EQ(part.map_width, 64);
  EXPECT_EQ(part.map, whole.map);
  float sum = 0.0F;
  for (const Rgb& texel : part.map) {
    sum += texel.r;
  }
  EXPECT_FLOAT_EQ(sum / (64.0F * 32.0F), 0.125F);
}

TEST_F(LoadEnvironment, OfSeveralLayersTheCombinedOneIsShown) {
  EXPECT_THAT(load(picture_file("env_multilayer_ao.exr")).map, Each(Rgb(0.5F, 0.25F, 0.125F)));
  const auto layers = [&](const std::string& file, const std::vector<std::string>& names) {
    return write(file, encoded_image({.format = "openexr",
                                      .width = 1,
                                      .height = 1,
                                      .channels = 6,
                                      .samples = std::vector<float>{1, 2, 3, 4, 5, 6},
                                      .channel_names = names}));
  };
  EXPECT_THAT(load(layers("one.exr", {"z.a", "z.b", "z.c", "x.R", "x.G", "x.B"})).map,
              ElementsAre(Rgb(4, 5, 6)));
  EXPECT_THAT(error_of(layers("two.exr", {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"})),
              HasSubstr("has no channels R, G and B but [\"a."));
}

/// The columns of the published matrix from ACES2065-1 to linear Rec. 709, D60 to D65 by Bradford.
TEST_F(LoadEnvironment, StatedPrimariesAreConverted) {
  Warnings warnings;  // of what is negative in Rec. 709
  const Environment environment = load_environment(picture_file("aces.exr"), warnings);
  const std::vector<Rgb> published = {{2.5216862F, -0.2764799F, -0.0153781F},
                                      {-1.1341310F, 1.3727191F, -0.1529753F},
                                      {-0.3875552F, -0.0962392F, 1.1683534F}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(environment.map[i][channel], std::max(0.0F, published[i][channel]), 1e-6F);
    }
  }
}

TEST_F(LoadEnvironment, PrimariesOfZerosAreTakenForRec709) {
  std::string file = read_file(picture_file("aces.exr"));
  const std::string name = std::string("chromaticities\0chromaticities\0", 30);
  const std::size_t at = file.find(name);
  ASSERT_NE(at, std::string::npos);
  file.replace(at + name.size() + 4, 32, std::string(32, '\0'));
  Warnings warnings;
  const Environment environment = load_environment(write("zeros.exr", file), warnings);
  EXPECT_THAT(warnings.lines(), Contains(HasSubstr("primaries that span no colour space")));
  for (std::size_t i = 0; i < 3; ++i) {
    Rgb primary(0.0F);
    primary[static_cast<int>(i)] = 1.0F;
    EXPECT_EQ(environment.map[i], primary);
  }
}

/// The picture's colour (200, 100, 50) by IEC 61966-2-1, within a code.
TEST_F(LoadEnvironment, ReadsThePicturesThatCompareReads) {
  for (const char* name : {"float.tif", "associated.tif"}) {
    Warnings warnings;
    const Rgb above = load_environment(picture_file(name), warnings).map.at(0);
    EXPECT_NEAR(above.r, 0.578, 0.007) << name;
    EXPECT_NEAR(above.g, 0.127, 0.004) << name;
    EXPECT_NEAR(above.b, 0.032, 0.004) << name;
  }
  Warnings warnings;
  EXPECT_NEAR(load_environment(picture_file("tx_alpha128.webp"), warnings).map.at(0).r, 0.578,
              0.007);
}

/// A picture of two rows, abc and def, as "File Formats" (Radiance 1997) says that scanlines run.
TEST_F(LoadEnvironment, RadianceScanlinesRunAsTheirHeaderSays) {
  const std::vector<std::pair<std::string, std::string>> scanlines = {
      {"-Y 2 +X 3", "abcdef"}, {"-Y 2 -X 3", "cbafed"}, {"+Y 2 +X 3", "defabc"},
      {"+Y 2 -X 3", "fedcba"}, {"+X 3 -Y 2", "adbecf"}, {"-X 3 -Y 2", "cfbead"},
      {"+X 3 +Y 2", "daebfc"}, {"-X 3 +Y 2", "fcebda"}};
  for (const auto& [resolution, letters] : scanlines) {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n";
    for (const char letter : letters) {
      file += std::string(3, letter) + "\x88";  // an exponent of 2^8, so that bytes are values
    }
    const Environment environment = load(write("picture.hdr", file));
    EXPECT_EQ(environment.map_width, 3) << resolution;
    std::string read;
    for (const Rgb& texel : environment.map) {
      read += static_cast<char>(texel.r);
    }
    EXPECT_EQ(read, "abcdef") << resolution;
  }
}

TEST_F(LoadEnvironment, RadianceIsBeforeTheExposureThatItsHeaderStates) {
  const auto picture = [&](const std::string& lines) {
    return load(write("picture.hdr", "#?RADIANCE\n" + lines + "\n-Y 1 +X 2\n" + "\x60\x80\x20\x88" +
                                         "\x60\x80\x20\x88"))
        .map.front();
  };
  EXPECT_EQ(picture("FORMAT=32-bit_rle_rgbe\n"), Rgb(96, 128, 32));
  EXPECT_EQ(picture("EXPOSURE=2\nFORMAT=32-bit_rle_rgbe\nEXPOSURE= 4.0 \nCOLORCORR=1 2 .5\n"),
            Rgb(12, 8, 8));
  EXPECT_THAT(error_of(write("odd.hdr",
                             "#?RADIANCE\nEXPOSURE=0\nFORMAT=32-bit_rle_rgbe\n\n"
                             "-Y 1 +X 1\n\x60\x80\x20\x88")),
              HasSubstr("EXPOSURE or COLORCORR is not a positive number"));
  const Rgb bt2020 =
      picture("PRIMARIES=.708 .292 .17 .797 .131 .046 .3127 .329\nFORMAT=32-bit_rle_rgbe\n");
  EXPECT_NEAR(bt2020.r, 1.6605 * 96 - 0.5876 * 128 - 0.0728 * 32, 0.1);  // ITU-R BT.2087-0
  EXPECT_THAT(error_of(write("odd.hdr",
                             "#?RADIANCE\nPRIMARIES=1 2\nFORMAT=32-bit_rle_rgbe\n\n"
                             "-Y 1 +X 1\n\x60\x80\x20\x88")),
              HasSubstr("too few numbers"));
  // IEC 61966-2-1: the inverse of the matrix from linear sRGB to CIE XYZ.
  const Rgb from_xyz = picture("FORMAT=32-bit_rle_xyze\n");
  EXPECT_NEAR(from_xyz.r, 3.2406 * 96 - 1.5372 * 128 - 0.4986 * 32, 0.1);
  EXPECT_NEAR(from_xyz.g, -0.9689 * 96 + 1.8758 * 128 + 0.0415 * 32, 0.1);
  EXPECT_NEAR(from_xyz.b, 0.0557 * 96 - 0.2040 * 128 + 1.0570 * 32, 0.1);
}

TEST_F(LoadEnvironment, WhatIsNoPanoramaIsNamed) {
  Warnings warnings;
  load_environment(write_floats("cube.exr", 4, 24, 3, std::vector<float>(4 * 24 * 3, 1)), warnings);
  EXPECT_THAT(warnings.lines(),
              ElementsAre("the environment has 4 x 24 pixels, not a panorama of 2 to 1: it is "
                          "stretched over the whole sphere (cube.exr)"));
}

TEST_F(LoadEnvironment, RefusesWhatIsNoImage) {
  EXPECT_THAT(error_of(folder() / "gone.exr"), HasSubstr("gone.exr: no such file"));
  EXPECT_THAT(error_of(folder()), HasSubstr("not a file"));
  EXPECT_THAT(error_of(write("text.exr", "this is no image")),
              HasSubstr("text.exr: is not an EXR, HDR, PNG, JPEG, WebP, BMP, GIF, TGA, TIFF"));
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
              HasSubstr("huge.hdr: is damaged: 52 bytes cannot hold 134217728 pixels"));
  std::string palette = one_pixel(1, 2, 3);
  palette.replace(16, 8, std::string("\0\0\x40\0\0\0\x20\0", 8));
  palette.replace(29, 4, "\xAD\x1C\xCB\x36");
  palette.append(100000, '\0');
  EXPECT_THAT(error_of(write("huge.png", palette)),
              HasSubstr("huge.png: would take 1536 MiB of memory, more than 256 and"));
}

TEST_F(LoadEnvironment, RefusesTilesThatAskForMuchMemory) {
  const std::filesystem::path file =
      write_floats("tiled.exr", 32, 16, 3, std::vector<float>(std::size_t{3} * 32 * 16, 1), 16);
  EXPECT_EQ(load(file).map_width, 32);
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
