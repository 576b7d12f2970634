#include "renderer/film/image_file.h"

#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/film/tone_mapping.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("images_" + std::to_string(::getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    image_.color = RgbImage(3, 2);
    for (int i = 0; i < 6; ++i) {
      image_.color.pixels[static_cast<std::size_t>(i)] =
          Rgb(0.1F * static_cast<float>(i), 1.0F / 3.0F, 1e6F);
      image_.samples.push_back(static_cast<std::uint32_t>(i * 1000));
    }
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
  FilmImage image_;
};

TEST_F(ImageFile, ExrKeepsColoursAndCounts) {
  write_film_image(folder_ / "a.exr", image_, 2.0);  // the exposure is the display's alone
  const FilmImage back = read_film_image(folder_ / "a.exr");
  EXPECT_EQ(back.color.width, 3);
  EXPECT_EQ(back.color.height, 2);
  EXPECT_EQ(back.color.pixels, image_.color.pixels);
  EXPECT_EQ(back.samples, image_.samples);
  EXPECT_EQ(entries(), 1);
}

TEST_F(ImageFile, ExrChannelsHaveTheirNames) {
  write_film_image(folder_ / "a.exr", image_, 0.0);
  const auto input = OIIO::ImageInput::open((folder_ / "a.exr").string());
  ASSERT_TRUE(input);
  EXPECT_THAT(input->spec().channelnames, testing::UnorderedElementsAre("R", "G", "B", "samples"));
  EXPECT_EQ(input->spec().format, OIIO::TypeDesc::FLOAT);
}

TEST_F(ImageFile, ExrWithoutCountsHasOneSampleAPixel) {
  write_image(folder_ / "a.exr", image_.color, 0.0);
  EXPECT_THAT(read_film_image(folder_ / "a.exr").samples, testing::Each(1U));
}

TEST_F(ImageFile, PngIsTheDisplaysImageInEightBits) {
  const RgbImage grey = [] {
    RgbImage image(2, 1);
    image.pixels = {Rgb(0.25F), Rgb(4.0F)};
    return image;
  }();
  write_image(folder_ / "a.png", grey, 1.0);
  const FilmImage back = read_film_image(folder_ / "a.png");
  EXPECT_NEAR(back.color.pixels[0].g, 0.5F, 0.004F);  // 0.25 times 2, in steps of 8-bit sRGB
  EXPECT_EQ(back.color.pixels[1], Rgb(1.0F));
}

TEST_F(ImageFile, OnlyExrAndPngAreWritten) {
  EXPECT_THAT([&] { require_image_extension("x.jpg"); },
              ThrowsMessage<UsageError>(HasSubstr(".jpg")));
  EXPECT_THROW(require_image_extension("x"), UsageError);
  EXPECT_NO_THROW(require_image_extension("x.EXR"));
  EXPECT_THROW(write_image(folder_ / "x.tif", image_.color, 0.0), UsageError);
  EXPECT_EQ(entries(), 0);
}

TEST_F(ImageFile, WhatCannotBeReadIsNamed) {
  write_file(folder_ / "text.exr", "no image");
  write_film_image(folder_ / "whole.exr", image_, 0.0);
  write_file(folder_ / "cut.exr", read_file(folder_ / "whole.exr").substr(0, 200));
  for (const char* name : {"text.exr", "cut.exr", "absent.exr", ""}) {
    EXPECT_THAT([&] { read_film_image(folder_ / name); },
                ThrowsMessage<Error>(HasSubstr((folder_ / name).string())));
  }
}

TEST_F(ImageFile, AFolderThatDoesNotExistIsNamedAndNothingIsLeft) {
  EXPECT_THAT([&] { write_image(folder_ / "no" / "a.exr", image_.color, 0.0); },
              ThrowsMessage<Error>(HasSubstr("does not exist")));
  EXPECT_EQ(entries(), 0);
}

// Values of IEC 61966-2-1.
TEST(ToneMapping, FollowsTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(1.0F), 1.0F);
  EXPECT_NEAR(srgb_from_linear(0.0031308F), 0.04045F, 1e-5F);
  EXPECT_NEAR(srgb_from_linear(0.21404114F), 0.5F, 1e-5F);
  EXPECT_NEAR(linear_from_srgb(0.5F), 0.21404114F, 1e-6F);
}

TEST(ToneMapping, StaysInRangeWhateverComes) {
  EXPECT_EQ(srgb_from_linear(-1.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(std::numeric_limits<float>::infinity()), 1.0F);
  EXPECT_EQ(srgb_from_linear(std::nanf("")), 0.0F);
}

TEST(ToneMapping, ExposureIsInStops) {
  RgbImage image(1, 1);
  image.pixels = {Rgb(0.125F)};
  EXPECT_NEAR(display_image(image, 2.0).pixels[0].r, srgb_from_linear(0.5F), 1e-6F);
  EXPECT_NEAR(display_image(image, -1.0).pixels[0].r, srgb_from_linear(0.0625F), 1e-6F);
}

}  // namespace
}  // namespace foveola
