#include "renderer/scene/textures/image_channels.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

DecodedImage row(int channels, const std::vector<std::uint8_t>& texels) {
  return {.width = static_cast<int>(texels.size()) / channels,
          .height = 1,
          .channels = channels,
          .texels = texels};
}

TEST(ImageChannels, AlphaComesFromTheMasksAlphaIfItHasOne) {
  const DecodedImage color = row(3, {1, 2, 3});
  EXPECT_THAT(with_alpha(color, row(1, {9})).texels, ElementsAre(1, 2, 3, 9));
  EXPECT_THAT(with_alpha(color, row(3, {9, 8, 7})).texels, ElementsAre(1, 2, 3, 9));
  EXPECT_THAT(with_alpha(color, row(4, {9, 8, 7, 6})).texels, ElementsAre(1, 2, 3, 6));
  EXPECT_THAT(with_alpha(color, row(2, {9, 6})).texels, ElementsAre(1, 2, 3, 6));
  EXPECT_THAT(with_alpha(color, row(4, {9, 8, 7, 255})).texels, ElementsAre(1, 2, 3, 9));
}

TEST(ImageChannels, GreyAndMissingColoursTakeTwoChannels) {
  EXPECT_THAT(with_alpha(row(1, {5}), row(1, {9})).texels, ElementsAre(5, 9));
  EXPECT_THAT(with_alpha(std::nullopt, row(1, {9})).texels, ElementsAre(255, 9));
}

TEST(ImageChannels, TheSmallerIsRepeated) {
  const DecodedImage result = with_alpha(row(1, {5, 6, 7, 8}), row(1, {0, 255}));
  EXPECT_EQ(result.width, 4);
  EXPECT_THAT(result.texels, ElementsAre(5, 0, 6, 0, 7, 255, 8, 255));
  EXPECT_THAT(with_alpha(row(1, {5, 6}), row(1, {1, 2, 3, 4})).texels,
              ElementsAre(5, 1, 5, 2, 6, 3, 6, 4));
}

/// Two long thin images must not make a large one.
TEST(ImageChannels, NeverLargerThanTheLargerOfTheTwo) {
  DecodedImage wide{.width = 1000, .height = 1, .channels = 1, .texels = {}};
  wide.texels.resize(1000);
  DecodedImage high{.width = 1, .height = 999, .channels = 1, .texels = {}};
  high.texels.resize(999);
  const DecodedImage result = roughness_metallic(wide, high);
  EXPECT_EQ(result.width, 1000);
  EXPECT_EQ(result.height, 1);
}

TEST(ImageChannels, MissingRoughnessOrMetalnessIsOne) {
  EXPECT_THAT(roughness_metallic(row(1, {5}), std::nullopt).texels, ElementsAre(255, 5, 255));
  EXPECT_THAT(roughness_metallic(std::nullopt, row(1, {6})).texels, ElementsAre(255, 255, 6));
}

TEST(ImageChannels, GlossinessWithoutAnAlphaIsOne) {
  EXPECT_THAT(roughness_of_glossiness(row(1, {7}), 0.6F).texels, ElementsAre(255, 102, 255));
  EXPECT_THAT(roughness_of_glossiness(row(4, {1, 2, 3, 0}), 0.6F).texels,
              ElementsAre(255, 255, 255));
}

}  // namespace
}  // namespace foveola
