#include <algorithm>

#include "renderer/commands/render/render_report.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// 1000 pixels, of which the first `count` have this value and the others a middle grey.
FilmImage image_of(float value, int count) {
  FilmImage image{
      .color = RgbImage(100, 10), .samples = std::vector<std::uint32_t>(1000, 1), .variances = {}};
  std::fill(image.color.pixels.begin(), image.color.pixels.end(), Rgb(0.18F));
  std::fill_n(image.color.pixels.begin(), count, Rgb(value));
  return image;
}

TEST(PictureFaults, BlackPicturesAreToldWithWhatMendsThem) {
  EXPECT_THAT(picture_faults(image_of(0.0F, 990), 0.0, false),
              ElementsAre(HasSubstr("99 % of the picture is black: --exposure auto")));
  EXPECT_THAT(picture_faults(image_of(0.0F, 900), 0.0, false), IsEmpty())
      << "an object before nothing";
  EXPECT_THAT(picture_faults(image_of(0.001F, 1000), -10.0, false),
              ElementsAre(HasSubstr("black")));
  EXPECT_THAT(picture_faults(image_of(1e-6F, 1000), 12.0, false), IsEmpty());
}

TEST(PictureFaults, NoLightFromOutsideIsProposedWhereNoneComesIn) {
  EXPECT_THAT(picture_faults(image_of(0.0F, 1000), 0.0, false),
              ElementsAre(HasSubstr("--environment")));
  EXPECT_THAT(
      picture_faults(image_of(0.0F, 1000), 0.0, true),
      ElementsAre(AllOf(Not(HasSubstr("--environment")), HasSubstr("needs lights within"))));
}

TEST(PictureFaults, WhitePicturesAreToldWithWhatMendsThem) {
  EXPECT_THAT(picture_faults(image_of(683.0F, 950), 0.0, false),
              ElementsAre(HasSubstr("95 % of the picture is white: --exposure auto")));
  EXPECT_THAT(picture_faults(image_of(683.0F, 950), 0.0, false),
              ElementsAre(HasSubstr("--light-units")));
  EXPECT_THAT(picture_faults(image_of(683.0F, 800), 0.0, false), IsEmpty());
  EXPECT_THAT(picture_faults(image_of(683.0F, 950), -10.0, false), IsEmpty());
}

TEST(PictureFaults, PixelsWithoutSamplesDoNotCount) {
  FilmImage image = image_of(0.0F, 990);
  std::fill_n(image.samples.begin(), 990, 0U);
  EXPECT_THAT(picture_faults(image, 0.0, false), IsEmpty());
  std::fill(image.samples.begin(), image.samples.end(), 0U);
  EXPECT_THAT(picture_faults(image, 0.0, false), IsEmpty());
}

}  // namespace
}  // namespace foveola::test
