#include "renderer/window/drawing/display_pictures.h"

#include "renderer/image/image_file.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

std::future<RgbImage> grey_picture() {
  std::promise<RgbImage> drawn;
  RgbImage picture(4, 2);
  for (Rgb& color : picture.pixels) {
    color = Rgb(0.5F);
  }
  drawn.set_value(picture);
  return drawn.get_future();
}

TEST(DisplayPicturesTest, BecomeFilesOfWhatWasSeen) {
  const test::TemporaryFolder folder;
  DisplayPictures pictures;
  pictures.write_privately(folder / "one.png", grey_picture());
  pictures.write_privately(folder / "two.png", grey_picture());
  pictures.finish();
  for (const char* name : {"one.png", "two.png"}) {
    const RgbImage read = read_film_image(folder / name).color;
    ASSERT_EQ(read.width, 4) << name;
    EXPECT_NEAR(read.at(3, 1).g, 0.2140, 0.003) << "0.5 of sRGB, as linear light";
    EXPECT_EQ(std::filesystem::status(folder / name).permissions(), std::filesystem::perms(0600));
  }
}

TEST(DisplayPicturesTest, WhatCannotBeWrittenIsReportedAndTheOthersAreWritten) {
  const test::TemporaryFolder folder;
  DisplayPictures pictures;
  pictures.write_privately(folder / "no-such-folder" / "one.png", grey_picture());
  pictures.write_privately(folder / "two.png", grey_picture());
  EXPECT_THAT(test::error_of([&] { pictures.finish(); }), HasSubstr("one.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "two.png"));
  EXPECT_NO_THROW(pictures.finish()) << "reported once";
}

TEST(DisplayPicturesTest, NumbersGoOnAfterThoseThatAreThere) {
  const test::TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  folder.write("foveola-1.png", "");
  DisplayPictures pictures;
  EXPECT_EQ(pictures.write_next(grey_picture()), "foveola-2.png");
  EXPECT_EQ(pictures.write_next(grey_picture()), "foveola-3.png");
  pictures.finish();
  EXPECT_TRUE(std::filesystem::exists("foveola-2.png") && std::filesystem::exists("foveola-3.png"));
  std::filesystem::current_path(before);
}

TEST(DisplayPicturesTest, AreSavedOnceTheyAreThere) {
  const test::TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  DisplayPictures pictures;
  std::promise<RgbImage> drawn;
  pictures.write_next(drawn.get_future());
  EXPECT_TRUE(pictures.take_written().empty());
  drawn.set_value(RgbImage(4, 2));
  const auto next = [&] {
    std::vector<DisplayPictures::Written> written;
    test::wait_until("a written picture",
                     [&] { return !(written = pictures.take_written()).empty(); });
    return written.front();
  };
  const DisplayPictures::Written saved = next();
  EXPECT_EQ(saved.fault, "");
  EXPECT_TRUE(std::filesystem::exists(saved.file));
  EXPECT_TRUE(pictures.take_written().empty()) << "once";
  std::filesystem::remove_all(folder.path());
  pictures.write_next(grey_picture());
  EXPECT_NE(next().fault, "") << "into a folder that is gone";
  EXPECT_NO_THROW(pictures.finish()) << "it was reported";
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace foveola
