#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/measure/region_error.h"

namespace foveola {
namespace {

RgbImage image_of(int width, int height, const std::vector<Rgb>& pixels) {
  RgbImage image(width, height);
  image.pixels = pixels;
  return image;
}

TEST(CompareImages, AgreesWithTheValuesByHand) {
  const RgbImage reference = image_of(2, 1, {Rgb(1.0F, 2.0F, 0.0F), Rgb(0.5F, 0.5F, 0.5F)});
  const RgbImage image = image_of(2, 1, {Rgb(1.5F, 1.0F, 0.25F), Rgb(0.5F, 0.5F, 0.5F)});
  const ErrorMetrics metrics = compare_images(image, reference, PixelWeight::uniform);
  EXPECT_NEAR(metrics.rmse, std::sqrt((0.25 + 1.0 + 0.0625) / 6.0), 1e-12);
  EXPECT_NEAR(metrics.relative_mse, (0.25 / 1.01 + 1.0 / 4.01 + 0.0625 / 0.01) / 6.0, 1e-12);
  EXPECT_NEAR(metrics.mean_image, 4.25 / 6.0, 1e-12);
  EXPECT_NEAR(metrics.mean_reference, 4.5 / 6.0, 1e-12);
  EXPECT_EQ(metrics.pixels, 2U);
  EXPECT_EQ(metrics.non_finite, 0U);
}

// Rows at elevations 60, 0 and -60 degrees have weights 1/2, 1 and 1/2; only the first differs.
TEST(CompareImages, WeighsRowsByTheCosineOfTheirLatitude) {
  const RgbImage reference = image_of(1, 3, {Rgb(0.0F), Rgb(0.0F), Rgb(0.0F)});
  const RgbImage image = image_of(1, 3, {Rgb(2.0F), Rgb(0.0F), Rgb(0.0F)});
  const ErrorMetrics metrics = compare_images(image, reference, PixelWeight::solid_angle);
  EXPECT_NEAR(metrics.rmse, std::sqrt(0.5 * 4.0 / 2.0), 1e-12);
  EXPECT_NEAR(metrics.relative_mse, 0.5 * 400.0 / 2.0, 1e-9);
  EXPECT_NEAR(metrics.mean_image, 0.5, 1e-12);
}

TEST(CompareImages, CountsNonFinitePixelsApart) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const RgbImage reference =
      image_of(2, 2, {Rgb(1.0F), Rgb(1.0F), Rgb(1.0F, infinity, 1.0F), Rgb(1.0F)});
  const RgbImage image = image_of(2, 2, {Rgb(1.0F, nan, 1.0F), Rgb(1.0F), Rgb(1.0F), Rgb(3.0F)});
  const ErrorMetrics metrics = compare_images(image, reference, PixelWeight::uniform);
  EXPECT_EQ(metrics.pixels, 2U);
  EXPECT_EQ(metrics.non_finite, 2U);
  EXPECT_NEAR(metrics.rmse, std::sqrt(2.0), 1e-12);
}

// No error is not the same as an error of nought.
TEST(CompareImages, HasNoAnswerWhereNothingCanBeCompared) {
  const RgbImage broken = image_of(1, 1, {Rgb(std::numeric_limits<float>::quiet_NaN())});
  const ErrorMetrics metrics = compare_images(broken, RgbImage(1, 1), PixelWeight::uniform);
  EXPECT_EQ(metrics.pixels, 0U);
  EXPECT_TRUE(std::isnan(metrics.rmse));
  EXPECT_TRUE(std::isnan(metrics.relative_mse));
}

// A float accumulator would stop growing at 2^24 and lose the small differences.
TEST(CompareImages, AccumulatesInDouble) {
  constexpr int side = 2048;
  RgbImage reference(side, side);
  RgbImage image(side, side);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    reference.pixels[i] = Rgb(0.0F);
    image.pixels[i] = i == 0 ? Rgb(4096.0F) : Rgb(0.01F);
  }
  const double count = static_cast<double>(image.pixels.size());
  const double small = static_cast<double>(0.01F);
  const double expected = (4096.0 * 4096.0 + (count - 1.0) * small * small) / count;
  const ErrorMetrics metrics = compare_images(image, reference, PixelWeight::uniform);
  EXPECT_NEAR(metrics.rmse * metrics.rmse / expected, 1.0, 1e-9);
}

TEST(CompareImages, RefusesImagesOfDifferentSizes) {
  EXPECT_THROW(compare_images(RgbImage(2, 1), RgbImage(1, 2), PixelWeight::uniform), Error);
}

}  // namespace
}  // namespace foveola
