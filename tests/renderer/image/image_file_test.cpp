#include "renderer/image/image_file.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/image/image_codec.h"
#include "tests/encoded_image.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    image_.color = RgbImage(3, 2);
    for (int i = 0; i < 6; ++i) {
      image_.color.pixels[static_cast<std::size_t>(i)] =
          Rgb(0.1F * static_cast<float>(i), 1.0F / 3.0F, 1e6F);
      image_.samples.push_back(static_cast<std::uint32_t>(i * 1000));
    }
  }

  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
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
  const std::string bytes = read_file(folder_ / "a.exr");
  const auto reader =
      image_codec().open_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                               "openexr", is_work_stopped);
  EXPECT_THAT(reader->header().channel_names,
              testing::UnorderedElementsAre("R", "G", "B", "samples"));
  EXPECT_TRUE(reader->header().has_floats);
}

TEST_F(ImageFile, ReadingEndsOnceItIsStopped) {
  const std::string bytes = test::encoded_image({.format = "png",
                                                 .width = 1,
                                                 .height = 10000,
                                                 .channels = 1,
                                                 .samples = std::vector<std::uint8_t>(10000, 7)});
  const auto last_row = [&](bool (*is_stopped)()) {
    std::vector<std::uint8_t> rows(10000);
    image_codec()
        .open_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "png",
                    is_stopped)
        ->read_bytes(rows.data());
    return rows.back();
  };
  EXPECT_EQ(last_row([] { return false; }), 7);
  EXPECT_EQ(last_row([] { return true; }), 0);
}

TEST_F(ImageFile, ExrWithoutCountsHasOneSampleAPixel) {
  write_image(folder_ / "a.exr", image_.color, 0.0);
  EXPECT_THAT(read_film_image(folder_ / "a.exr").samples, Each(1U));
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

TEST_F(ImageFile, JpegIsTheDisplaysImageToo) {
  RgbImage grey(16, 8);
  grey.pixels.assign(grey.pixels.size(), Rgb(0.25F));
  write_image(folder_ / "a.jpg", grey, 1.0);
  EXPECT_NEAR(read_film_image(folder_ / "a.jpg").color.pixels[0].g, 0.5F, 0.01F);
}

// Where the formats' specifications have it: a viewer looks into no other place.
TEST_F(ImageFile, APanoramaSaysThatItIsOne) {
  const RgbImage grey(16, 8);
  const ImageFacts facts = {{projection_fact, panorama_projection}};
  for (const char* name : {"a.png", "a.jpg"}) {
    write_film_image(folder_ / name, {.color = grey, .samples = {}, .variances = {}}, 0.0, facts);
    const std::string bytes = read_file(folder_ / name);
    EXPECT_THAT(bytes, AllOf(HasSubstr("GPano:ProjectionType=\"equirectangular\""),
                             HasSubstr("GPano:FullPanoWidthPixels=\"16\""),
                             HasSubstr("GPano:FullPanoHeightPixels=\"8\"")));
    EXPECT_EQ(read_film_image(folder_ / name).color.width, 16) << "and is read as before";
    write_image(folder_ / name, grey, 0.0);
    EXPECT_THAT(read_file(folder_ / name), Not(HasSubstr("GPano")));
  }
  write_film_image(folder_ / "a.png", {.color = grey, .samples = {}, .variances = {}}, 0.0, facts);
  const std::string png = read_file(folder_ / "a.png");
  EXPECT_EQ(png.substr(37, 22), std::string("iTXtXML:com.adobe.xmp\0", 22));
  write_film_image(folder_ / "a.jpg", {.color = grey, .samples = {}, .variances = {}}, 0.0, facts);
  const std::string jpeg = read_file(folder_ / "a.jpg");
  const std::size_t app1 = jpeg.find("\xFF\xE1");
  EXPECT_EQ(jpeg.substr(app1 + 4, 29), std::string("http://ns.adobe.com/xap/1.0/\0", 29));
  EXPECT_EQ(app1, 2U + 18U) << "behind JFIF's segment";
}

TEST_F(ImageFile, NothingElseIsWritten) {
  EXPECT_THAT([&] { require_image_extension("x.tif"); },
              ThrowsMessage<UsageError>(HasSubstr(".tif")));
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

// The header of a small file is changed to promise 65536 x 65536 pixels.
TEST_F(ImageFile, AHeaderIsNotBelievedBlindly) {
  write_film_image(folder_ / "a.exr", image_, 0.0);
  std::string bytes = read_file(folder_ / "a.exr");
  const std::string attribute("dataWindow\0box2i\0\x10\0\0\0", 21);
  const std::size_t window = bytes.find(attribute);
  ASSERT_NE(window, std::string::npos);
  bytes.replace(window + attribute.size() + 8, 8, std::string("\xFF\xFF\0\0\xFF\xFF\0\0", 8));
  bytes.resize(bytes.size() + (1U << 16));  // room for the table of where its rows begin
  write_file(folder_ / "a.exr", bytes);
  EXPECT_THAT([&] { read_film_image(folder_ / "a.exr"); },
              ThrowsMessage<Error>(HasSubstr("cannot hold 4294967296 pixels")));
}

TEST_F(ImageFile, CountsOfAStrangerAreBroughtIntoRange) {
  const float nan = std::nanf("");
  const std::vector<float> values = {1, 2, 3, nan, 1, 2, 3, -5, 1, 2, 3, 1e30F, 1, 2, 3, 7.9F};
  write_file(folder_ / "a.exr", test::encoded_image({.format = "openexr",
                                                     .width = 4,
                                                     .height = 1,
                                                     .channels = 4,
                                                     .samples = values,
                                                     .channel_names = {"R", "G", "B", "samples"}}));
  const FilmImage image = read_film_image(folder_ / "a.exr");
  EXPECT_THAT(image.samples, ElementsAre(0U, 0U, 0xFFFFFF00U, 7U));
  EXPECT_THAT(image.color.pixels, Each(Rgb(1, 2, 3)));
}

TEST_F(ImageFile, GreyImagesBecomeColours) {
  const std::vector<std::uint8_t> values = {0, 128};
  write_file(folder_ / "a.png", test::encoded_image({"png", 2, 1, 1, values}));
  const FilmImage image = read_film_image(folder_ / "a.png");
  EXPECT_EQ(image.color.pixels[0], Rgb(0.0F));
  EXPECT_NEAR(image.color.pixels[1].r, 0.2158605F, 1e-6F);  // IEC 61966-2-1 of 128 / 255
  EXPECT_EQ(image.color.pixels[1], Rgb(image.color.pixels[1].r));
}

fs::path picture_file(const std::string& name) {
  return fs::path(TEST_DATA_DIR) / "pictures" / name;
}

TEST_F(ImageFile, SixteenBitsAreSrgbAsEightAre) {
  const std::vector<Rgb> ramp8 = read_film_image(picture_file("ramp8.png")).color.pixels;
  const std::vector<Rgb> ramp16 = read_film_image(picture_file("ramp16.png")).color.pixels;
  ASSERT_EQ(ramp8.size(), ramp16.size());
  for (std::size_t i = 0; i < ramp8.size(); ++i) {
    EXPECT_NEAR(ramp8[i].g, ramp16[i].g, 1e-6F);
  }
}

TEST_F(ImageFile, AnAlphaDarkensNoColour) {
  for (const char* name : {"tx_alpha128.png", "tx_alpha128.webp"}) {
    const Rgb first = read_film_image(picture_file(name)).color.pixels.front();
    EXPECT_NEAR(first.r, 0.5775804F, 1e-6F) << name;  // IEC 61966-2-1 of 200 / 255
    EXPECT_NEAR(first.g, 0.0129830F, 1e-6F) << name;  // and of 30 / 255
  }
}

TEST_F(ImageFile, ReadsPnm) {
  write_file(folder_ / "a.ppm", "P6 1 1 255\n\xC8\x1E\x1E");
  EXPECT_NEAR(read_film_image(folder_ / "a.ppm").color.pixels.front().r, 0.5775804F, 1e-6F);
}

TEST_F(ImageFile, WhatStandsInTheWayIsLeftAlone) {
  fs::create_directories(folder_ / "a.exr");
  EXPECT_THROW(write_film_image(folder_ / "a.exr", image_, 0.0), Error);
  EXPECT_TRUE(fs::is_directory(folder_ / "a.exr"));
  EXPECT_EQ(entries(), 1);
}

TEST_F(ImageFile, AFolderThatDoesNotExistIsNamedAndNothingIsLeft) {
  EXPECT_THAT([&] { write_image(folder_ / "no" / "a.exr", image_.color, 0.0); },
              ThrowsMessage<Error>(HasSubstr("does not exist")));
  EXPECT_EQ(entries(), 0);
}

}  // namespace
}  // namespace foveola
