#include "renderer/measure/flip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/image/tone_mapping.h"
#include "tests/matchers.h"
#include "tests/noisy_pair.h"

namespace foveola {
namespace {

using testing::FloatNear;

RgbImage plain(const Rgb& color) {
  RgbImage image(9, 7);
  std::fill(image.pixels.begin(), image.pixels.end(), color);
  return image;
}

/// The two images whose errors the authors' own program was asked for.
RgbImage stripes() {
  RgbImage image(24, 16);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y) = Rgb(x / 3 % 2 == 0 ? 0.8F : 0.25F, static_cast<float>(y) / 16.0F, 0.5F);
    }
  }
  return image;
}

RgbImage damaged_stripes() {
  RgbImage image = stripes();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if ((x + 2 * y) % 5 == 0) {
        image.at(x, y).r = 1.0F - image.at(x, y).r;
        image.at(x, y).b = 0.75F;
      }
    }
  }
  image.at(17, 6) = Rgb(1.0F);
  return image;
}

/// What the program of the paper's authors (FLIP.h of github.com/NVlabs/flip, without CUDA) gives
/// for them, once they are decoded to the linear values that it expects.
struct Golden {
  double pixels_per_degree;
  double mean;
  float top_left;      ///< a changed pixel at the border
  float at_17_6;       ///< the white one
  float at_5_11;       ///< unchanged, in the middle
  float bottom_right;  ///< unchanged
};

class FlipGolden : public testing::TestWithParam<Golden> {};

TEST_P(FlipGolden, AgreesWithTheAuthorsProgram) {
  const Golden& golden = GetParam();
  const std::vector<float> errors =
      flip_errors(damaged_stripes(), stripes(), golden.pixels_per_degree);
  ASSERT_EQ(errors.size(), 24U * 16U);
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / (24.0 * 16.0);
  constexpr float rounding_of_floats = 1e-4F;
  EXPECT_NEAR(mean, golden.mean, rounding_of_floats);
  EXPECT_NEAR(errors[0], golden.top_left, rounding_of_floats);
  EXPECT_NEAR(errors[6 * 24 + 17], golden.at_17_6, rounding_of_floats);
  EXPECT_NEAR(errors[11 * 24 + 5], golden.at_5_11, rounding_of_floats);
  EXPECT_NEAR(errors[15 * 24 + 23], golden.bottom_right, rounding_of_floats);
}

INSTANTIATE_TEST_SUITE_P(
    Flip, FlipGolden,
    testing::Values(Golden{67.0, 0.2784366, 0.500448F, 0.495462F, 0.264691F, 0.216588F},
                    Golden{20.0, 0.3235179, 0.791493F, 0.980244F, 0.252675F, 0.084292F},
                    Golden{5.0, 0.1813903, 0.853795F, 0.996307F, 0.001543F, 0.0F}));

TEST(Flip, EqualImagesHaveNone) {
  EXPECT_THAT(flip_errors(stripes(), stripes(), 67.0), Each(0.0F));
}

// Plain images have neither edges nor points, and no blur changes them: what is left is section
// 4.1's mapping of the distance in Lab. That of green to blue is the largest and so becomes 1; of
// black to white it is 100, and the largest to the power of 0.7 is 41.2760.
TEST(Flip, PlainColoursHaveTheErrorOfTheirDistance) {
  EXPECT_THAT(flip_errors(plain({0.0F, 1.0F, 0.0F}), plain({0.0F, 0.0F, 1.0F}), 30.0),
              Each(FloatNear(1.0F, 1e-5F)));
  const double knee = 0.4 * 41.2760;
  const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - knee) / (41.2760 - knee);
  EXPECT_THAT(flip_errors(plain(Rgb(0.0F)), plain(Rgb(1.0F)), 30.0),
              Each(FloatNear(static_cast<float>(expected), 1e-4F)));
}

// Where a pixel is wider than any feature, plain colours still have no features.
TEST(Flip, CoarseDisplaysHaveNoFeaturesInPlainColours) {
  EXPECT_THAT(flip_errors(plain(Rgb(0.0F)), plain(Rgb(1.0F)), 1.0),
              Each(FloatNear(0.9674F, 1e-4F)));
}

TEST(Flip, RefusesWhatCannotBeCompared) {
  EXPECT_THROW((void)flip_errors(RgbImage(2, 1), RgbImage(1, 2), 67.0), Error);
  for (const double density : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)flip_errors(RgbImage(2, 2), RgbImage(2, 2), density), Error) << density;
  }
}

// 90 degrees are two half widths of one distance: 0.01745 of it is a degree in the middle.
TEST(PixelsPerDegree, IsThatOfTheMiddle) {
  EXPECT_NEAR(pixels_per_degree(radians(90.0), 1000), 500.0 * 0.0174533, 1e-3);
  EXPECT_NEAR(pixels_per_degree(radians(1.0), 67), 67.0, 0.01);
}

/// Mean of the errors of 512 x 512 pixels.
double mean_of(const std::vector<float>& errors) {
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

RgbImage radiance_of(const RgbImage& encoded) {
  RgbImage linear = encoded;
  for (Rgb& pixel : linear.pixels) {
    pixel = 16.0F * Rgb(linear_from_srgb(pixel.r));
  }
  return linear;
}

TEST(HdrFlip, IsTheAuthorsOfAPairOfRadiances) {
  // Means of the authors' program.
  constexpr double pixels_per_degree = 67.0206;
  const test::NoisyPair pair = test::noisy_pair();
  EXPECT_NEAR(mean_of(flip_errors(pair.image, pair.reference, pixels_per_degree)), 0.047088, 1e-5);
  EXPECT_NEAR(mean_of(hdr_flip_errors(radiance_of(pair.image), radiance_of(pair.reference),
                                      pixels_per_degree)),
              0.044649, 1e-5);
}

TEST(HdrFlip, RefusesWhatIsNoRadiance) {
  const RgbImage grey = plain(Rgb(0.5F));
  for (const float value :
       {-1.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    RgbImage damaged = grey;
    damaged.at(3, 2).g = value;
    EXPECT_THROW(hdr_flip_errors(damaged, grey, 60.0), Error);
    EXPECT_THROW(hdr_flip_errors(grey, damaged, 60.0), Error);
  }
  EXPECT_THROW(hdr_flip_errors(grey, plain(Rgb(0.0F)), 60.0), Error);
}

}  // namespace
}  // namespace foveola
