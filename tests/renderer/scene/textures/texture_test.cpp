#include "renderer/scene/textures/texture.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <gmock/gmock.h>

namespace foveola {
namespace {

/// One row of greys.
Texture row(const std::vector<std::uint8_t>& greys, Wrap wrap, bool is_srgb = false) {
  std::vector<std::uint8_t> texels;
  for (const std::uint8_t grey : greys) {
    texels.insert(texels.end(), {grey, grey, grey, 255});
  }
  return {static_cast<int>(greys.size()), 1, texels, is_srgb, wrap, wrap};
}

float red_at(const Texture& texture, float u) { return texture.sample({u, 0.5F}).r * 255.0F; }

/// Texel centres lie at half integers.
TEST(Texture, InterpolatesBetweenCentresAndWrapsAtTheEdges) {
  using Samples = std::vector<std::pair<float, float>>;
  for (const auto& [wrap, samples] : std::vector<std::pair<Wrap, Samples>>{
           {Wrap::repeat,
            {{0.125F, 10.0F},
             {0.375F, 50.0F},
             {0.625F, 200.0F},
             {0.875F, 100.0F},
             {0.25F, 30.0F},
             {0.4375F, 50.0F + 0.25F * 150.0F},
             {0.0F, 55.0F},
             {1.0F, 55.0F},
             {3.375F, 50.0F},
             {-0.125F, 100.0F},
             {-1e-9F, 55.0F}}},
           {Wrap::clamp_to_edge, {{0.0F, 10.0F}, {-7.0F, 10.0F}, {1.0F, 100.0F}, {1e30F, 100.0F}}},
           {Wrap::mirrored_repeat,
            {{0.0F, 10.0F},
             {1.0F, 100.0F},
             {1.375F, 200.0F},
             {-0.375F, 50.0F},
             {2.375F, 50.0F},
             {1.75F, 30.0F}}}}) {
    const Texture texture = row({10, 50, 200, 100}, wrap);
    for (const auto& [u, value] : samples) {
      EXPECT_NEAR(red_at(texture, u), value, 1e-4F) << u;
    }
  }
}

TEST(Texture, InterpolatesInBothDirections) {
  const Texture texture(2, 2, {0, 0, 0, 255, 80, 0, 0, 255, 160, 0, 0, 255, 240, 0, 0, 255}, false,
                        Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  EXPECT_NEAR(texture.sample({0.25F, 0.75F}).r * 255.0F, 160.0F, 1e-4F) << "rows run downwards";
  EXPECT_NEAR(texture.sample({0.375F, 0.625F}).r * 255.0F, 0.25F * 80.0F + 0.75F * 160.0F, 1e-3F);
}

TEST(Texture, WrapsEachAxisItsOwnWay) {
  const Texture texture(2, 2, {0, 0, 0, 255, 80, 0, 0, 255, 160, 0, 0, 255, 240, 0, 0, 255}, false,
                        Wrap::repeat, Wrap::clamp_to_edge);
  EXPECT_NEAR(texture.sample({1.25F, 1.75F}).r * 255.0F, 160.0F, 1e-4F);
}

TEST(Texture, InterpolatesLightNotCode) {
  const Texture texture = row({0, 255}, Wrap::clamp_to_edge, true);
  EXPECT_NEAR(texture.sample({0.5F, 0.5F}).g, 0.5F, 1e-6F);
}

TEST(Texture, TransparentTexelsHaveNoColour) {
  const DecodedImage image{
      .width = 2, .height = 1, .channels = 4, .texels = {100, 200, 30, 255, 0, 0, 0, 0}};
  const Texture texture(std::make_shared<const Texels>(image, false, true, true),
                        {.wrap_u = Wrap::clamp_to_edge});
  for (const float u : {0.3F, 0.5F, 0.7F}) {
    const Vec4 value = texture.sample({u, 0.5F});
    EXPECT_NEAR(value.r * 255.0F, 100.0F, 1e-3F);
    EXPECT_NEAR(value.g * 255.0F, 200.0F, 1e-3F);
    EXPECT_NEAR(value.a, 1.5F - 2.0F * u, 1e-6F);
  }
  EXPECT_EQ(texture.sample({1.0F, 0.5F}).a, 0.0F);
}

/// A coarser level of other opacity counts as far as it is visible.
TEST(Texture, LevelsAreMixedByTheirOpacity) {
  DecodedImage image{.width = 8, .height = 8, .channels = 4, .texels = {}};
  for (int i = 0; i < 64; ++i) {
    const std::uint8_t seen = i % 8 < 2 ? 255 : 0;
    image.texels.insert(image.texels.end(), {seen, 50, 0, seen});
  }
  const Texture texture(std::make_shared<const Texels>(image, false, true, true), {});
  const Vec4 value = texture.sample({0.125F, 0.5F}, std::sqrt(2.0F) / 8.0F);
  EXPECT_NEAR(value.r, 1.0F, 1e-5F);
  EXPECT_NEAR(value.g * 255.0F, 50.0F, 0.5F);
}

TEST(Texture, AlphaIsNeverSrgb) {
  const Texture texture(1, 1, {255, 255, 255, 51}, true, Wrap::repeat, Wrap::repeat);
  EXPECT_NEAR(texture.sample({0.5F, 0.5F}).a, 0.2F, 1e-7F);
}

TEST(Texture, OneTexelIsConstantExactly) {
  const Texture texture(1, 1, {255, 0, 255, 255}, true, Wrap::repeat, Wrap::mirrored_repeat);
  for (const float u : {-0.3F, 0.0F, 0.1F, 0.99F, 5.4321F}) {
    EXPECT_EQ(texture.sample({u, 1.0F - u}), Vec4(1.0F, 0.0F, 1.0F, 1.0F));
  }
}

TEST(Texture, SurvivesAnyCoordinate) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float largest = std::numeric_limits<float>::max();
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
    const Texture texture = row({10, 50, 200}, wrap);
    for (const Vec2 uv :
         {Vec2(nan, 0.0F), Vec2(0.5F, nan), Vec2(infinity, 0.0F), Vec2(0.5F, -infinity)}) {
      EXPECT_NEAR(texture.sample(uv).r * 255.0F, 10.0F, 1e-4F);
    }
    for (const float u : {largest, -largest, 1e9F, -1e9F, 16777217.0F}) {
      const float red = red_at(texture, u);
      EXPECT_GE(red, 9.999F);
      EXPECT_LE(red, 200.001F);
    }
  }
}

Texture grey(int width, int height, const std::vector<std::uint8_t>& codes,
             const Sampler& sampler = {}, bool with_mips = true) {
  return {DecodedImage{.width = width, .height = height, .channels = 1, .texels = codes}, false,
          sampler, with_mips};
}

TEST(Texture, FillsMissingChannels) {
  const auto value = [](int channels) {
    std::vector<std::uint8_t> texels{51, 102, 153, 204};
    texels.resize(static_cast<std::size_t>(channels));
    return Texture({.width = 1, .height = 1, .channels = channels, .texels = texels}, false, {})
        .sample({0.5F, 0.5F});
  };
  const auto near = [](const Vec4& expected) {
    return ::testing::Truly(
        [expected](const Vec4& v) { return glm::length(v - expected) < 1e-6F; });
  };
  EXPECT_THAT(value(1), near(Vec4(0.2F, 0.2F, 0.2F, 1.0F)));
  EXPECT_THAT(value(2), near(Vec4(0.2F, 0.2F, 0.2F, 0.4F)));
  EXPECT_THAT(value(3), near(Vec4(0.2F, 0.4F, 0.6F, 1.0F)));
  EXPECT_THAT(value(4), near(Vec4(0.2F, 0.4F, 0.6F, 0.8F)));
}

TEST(Texture, OnlyTheSecondOfTwoAndTheFourthOfFourAreAlpha) {
  const auto of_channels = [](int channels) {
    return Texture({.width = 1,
                    .height = 1,
                    .channels = channels,
                    .texels = std::vector<std::uint8_t>(static_cast<std::size_t>(channels), 188)},
                   true, {});
  };
  constexpr float decoded = 0.502886F;
  constexpr float alpha = 188.0F / 255.0F;
  for (const int channels : {1, 2, 3, 4}) {
    const Texture texture = of_channels(channels);
    const Vec4 value = texture.sample({0.5F, 0.5F});
    EXPECT_NEAR(value.r, decoded, 1e-5F);
    EXPECT_NEAR(value.b, decoded, 1e-5F);
    const bool has_alpha = channels == 2 || channels == 4;
    EXPECT_NEAR(value.a, has_alpha ? alpha : 1.0F, 1e-6F);
  }
}

/// A 256 x 256 image of 3 channels, and a third more of it for the levels.
TEST(Texture, TakesTheMemoryOfItsBytes) {
  const DecodedImage image{.width = 256,
                           .height = 256,
                           .channels = 3,
                           .texels = std::vector<std::uint8_t>(3 * 256 * 256, 7)};
  const std::size_t plain = Texels(image, true, false).memory_bytes();
  EXPECT_GE(plain, 3U * 256U * 256U);
  EXPECT_LE(plain, 3U * 256U * 256U + 1000U);
  const std::size_t with_levels = Texels(image, true, true).memory_bytes();
  EXPECT_GE(with_levels, 4U * 256U * 256U - 4U);
  EXPECT_LE(with_levels, 4U * 256U * 256U + 1000U);
}

/// The codes 0, 0, 120, 240 sixteen times in a row. Each four are 0, 180 in the next level and 90
/// in the last.
DecodedImage sixteen_fours() {
  DecodedImage image{.width = 64, .height = 1, .channels = 1, .texels = {}};
  for (int i = 0; i < 16; ++i) {
    image.texels.insert(image.texels.end(), {0, 0, 120, 240});
  }
  return image;
}

/// As a code, at `u` of one of those fours, of a footprint `width` of them wide.
float red_of_four(const Texture& texture, float u, float width) {
  return texture.sample({(8.0F + u) / 16.0F, 0.5F}, width / 16.0F).r * 255.0F;
}

TEST(Texture, SharesTexelsUnderSamplersOfItsOwn) {
  const auto texels = std::make_shared<const Texels>(sixteen_fours(), false, true);
  const Texture smooth(texels, {.wrap_u = Wrap::clamp_to_edge});
  const Texture flat(texels, {.mip = MipFilter::none});
  const Texture coarse(texels, {.magnification = Filter::nearest});
  EXPECT_EQ(&smooth.texels(), &flat.texels());
  EXPECT_NEAR(red_of_four(smooth, 0.75F, 0.5F), 180.0F, 1e-3F);
  EXPECT_NEAR(red_of_four(flat, 0.625F, 1.0F), 120.0F, 1e-3F);
  EXPECT_NEAR(red_at(coarse, (8.0F + 0.7F) / 16.0F), 120.0F, 1e-4F);
}

TEST(Texture, WideFootprintsReadCoarserLevels) {
  const Texture texture(sixteen_fours(), false, {});
  EXPECT_NEAR(red_of_four(texture, 0.625F, 0.25F), 120.0F, 1e-3F) << "a footprint of one texel";
  EXPECT_NEAR(red_of_four(texture, 0.75F, 0.5F), 180.0F, 1e-3F) << "a footprint of two";
  EXPECT_NEAR(red_of_four(texture, 0.5F, 0.5F), 90.0F, 1e-3F) << "linear within a level";
  EXPECT_NEAR(red_of_four(texture, 0.3F, 1.0F), 90.0F, 1e-3F);
  EXPECT_NEAR(red_of_four(texture, 0.3F, 1e30F), 90.0F, 1e-3F);
  const float between = 0.25F * std::sqrt(2.0F);
  EXPECT_NEAR(red_of_four(texture, 0.875F, between), 0.5F * (240.0F + 135.0F), 1e-2F)
      << "linear between levels, and in the coarser one a quarter of the way to the next 0";
}

TEST(Texture, WidthsThatAreNoneReadTheFinestLevel) {
  const Texture texture(sixteen_fours(), false, {});
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float width :
       {0.0F, -1.0F, 1e-30F, infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_EQ(texture.sample({0.7F, 0.5F}, width), texture.sample({0.7F, 0.5F})) << width;
  }
}

TEST(Texture, WithoutLevelsEveryFootprintReadsTheFinest) {
  for (const Texture& texture : {Texture(sixteen_fours(), false, {}, false),
                                 Texture(sixteen_fours(), false, {.mip = MipFilter::none})}) {
    EXPECT_EQ(texture.sample({0.7F, 0.5F}, 1.0F), texture.sample({0.7F, 0.5F}));
  }
}

TEST(Texture, NearestTakesTheTexelThatHoldsThePoint) {
  const Texture texture = grey(4, 1, {10, 50, 200, 100}, {.magnification = Filter::nearest});
  for (const auto& [u, code] : std::vector<std::pair<float, float>>{{0.01F, 10.0F},
                                                                    {0.24F, 10.0F},
                                                                    {0.26F, 50.0F},
                                                                    {0.74F, 200.0F},
                                                                    {0.99F, 100.0F},
                                                                    {-0.01F, 100.0F},
                                                                    {1.01F, 10.0F}}) {
    EXPECT_NEAR(red_at(texture, u), code, 1e-4F) << u;
  }
}

TEST(Texture, MinificationHasFiltersOfItsOwn) {
  const auto red = [](Filter minification, MipFilter mip, float u, float width) {
    const Texture texture(sixteen_fours(), false, {.minification = minification, .mip = mip});
    return red_of_four(texture, u, width);
  };
  EXPECT_NEAR(red(Filter::nearest, MipFilter::nearest, 0.55F, 0.5F), 180.0F, 1e-3F);
  EXPECT_NEAR(red(Filter::nearest, MipFilter::nearest, 0.55F, 0.375F), 180.0F, 1e-3F)
      << "level 0.58";
  EXPECT_NEAR(red(Filter::linear, MipFilter::nearest, 0.5F, 0.6F), 90.0F, 1e-3F);
  EXPECT_NEAR(red(Filter::linear, MipFilter::nearest, 0.875F, 0.3F), 240.0F, 1e-3F);
  EXPECT_NEAR(red(Filter::nearest, MipFilter::none, 0.55F, 0.5F), 120.0F, 1e-3F);
}

}  // namespace
}  // namespace foveola
