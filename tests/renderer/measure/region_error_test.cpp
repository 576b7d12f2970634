#include "renderer/measure/region_error.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

RgbImage image_of(const std::vector<Rgb>& pixels) {
  RgbImage image(static_cast<int>(pixels.size()), 1);
  image.pixels = pixels;
  return image;
}

TEST(RegionErrorOf, AgreesWithTheValuesByHand) {
  const FilmImage image{.color = image_of({Rgb(1.0F), Rgb(2.0F, 0.0F, 0.0F), Rgb(9.0F)}),
                        .samples = {4, 8, 1},
                        .variances = {}};
  const ReferenceHalves reference{image_of({Rgb(0.5F), Rgb(1.0F, 0.0F, 0.0F), Rgb(0.0F)}),
                                  image_of({Rgb(0.0F), Rgb(1.0F, 0.0F, 0.0F), Rgb(0.0F)})};
  const RegionError error = region_error(image, reference, {{{0, 3.0F}, {1, 1.0F}}});
  // 0.5 * 1 in each of three channels, and 1 * 1 in one.
  EXPECT_NEAR(error.mse, (3.0 * 3.0 * 0.5 + 1.0) / (3.0 * 4.0), 1e-12);
  EXPECT_NEAR(error.relative_mse, (3.0 * 3.0 * 0.5 / (0.0625 + 0.01) + 1.0 / 1.01) / (3.0 * 4.0),
              1e-9);
  EXPECT_NEAR(error.samples_per_pixel, (3.0 * 4.0 + 8.0) / 4.0, 1e-12);
  EXPECT_EQ(error.empty_share, 0.0);
  EXPECT_EQ(error.pixels, 2U);
}

TEST(RegionErrorOf, EmptyAndNonFinitePixelsAreCountedApart) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const FilmImage image{.color = image_of({Rgb(7.0F), Rgb(1.0F, nan, 1.0F), Rgb(1.0F), Rgb(3.0F)}),
                        .samples = {0, 1, 1, 1},
                        .variances = {}};
  const ReferenceHalves reference{image_of({Rgb(0.0F), Rgb(0.0F), Rgb(nan), Rgb(1.0F)}),
                                  image_of({Rgb(0.0F), Rgb(0.0F), Rgb(0.0F), Rgb(1.0F)})};
  const RegionError error =
      region_error(image, reference, {{{0, 1.0F}, {1, 1.0F}, {2, 1.0F}, {3, 1.0F}}});
  EXPECT_EQ(error.empty, 1U);
  EXPECT_EQ(error.non_finite, 2U);
  EXPECT_EQ(error.pixels, 1U);
  EXPECT_NEAR(error.empty_share, 0.25, 1e-12);
  EXPECT_NEAR(error.mse, 4.0, 1e-12);
  const RegionError none = region_error(image, reference, {{{0, 1.0F}}});
  EXPECT_TRUE(std::isnan(none.mse));
}

// A reference as noisy as the image would treble its error if its own were not taken out.
TEST(RegionErrorOf, TheReferencesNoiseDoesNotCount) {
  constexpr std::size_t count = 200'000;
  Pcg32 generator(7);
  const auto noisy = [&](double deviation) {
    std::vector<Rgb> pixels;
    for (std::size_t i = 0; i < count; ++i) {
      pixels.push_back(Rgb(static_cast<float>(2.0 + deviation * generator.normal())));
    }
    return image_of(pixels);
  };
  const FilmImage image{.color = noisy(0.1), .samples = std::vector(count, 1U), .variances = {}};
  PixelRegion all;
  for (std::uint32_t i = 0; i < count; ++i) {
    all.pixels.push_back({i, 1.0F});
  }
  const RegionError error = region_error(image, {noisy(0.2), noisy(0.2)}, all);
  // (x - A)(x - B) has the variance 2 s^4 + 2 s^2 r^2 + r^4 with s = 0.1 and r = 0.2.
  const double standard_error = std::sqrt((2e-4 + 2.0 * 4e-4 + 16e-4) / count);
  EXPECT_NEAR(error.mse, 0.01, 4.0 * standard_error);
}

TEST(RegionMean, IsWeighted) {
  EXPECT_NEAR(region_mean({5.0F, 1.0F, 4.0F}, {{{1, 3.0F}, {2, 1.0F}}}), 7.0 / 4.0, 1e-12);
  EXPECT_TRUE(std::isnan(region_mean({1.0F}, {})));
}

}  // namespace
}  // namespace foveola
