#include "renderer/scene/texture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

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

TEST(Texture, TexelCentresLieAtHalfIntegers) {
  const Texture texture = row({10, 50, 200, 100}, Wrap::repeat);
  EXPECT_NEAR(red_at(texture, 0.125F), 10.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 0.375F), 50.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 0.625F), 200.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 0.875F), 100.0F, 1e-4F);
}

TEST(Texture, InterpolatesLinearlyBetweenCentres) {
  const Texture texture = row({10, 50, 200, 100}, Wrap::repeat);
  EXPECT_NEAR(red_at(texture, 0.25F), 30.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 0.4375F), 50.0F + 0.25F * 150.0F, 1e-4F);
}

TEST(Texture, InterpolatesInBothDirections) {
  const Texture texture(2, 2, {0, 0, 0, 255, 80, 0, 0, 255, 160, 0, 0, 255, 240, 0, 0, 255}, false,
                        Wrap::clamp_to_edge, Wrap::clamp_to_edge);
  EXPECT_NEAR(texture.sample({0.25F, 0.75F}).r * 255.0F, 160.0F, 1e-4F) << "rows run downwards";
  EXPECT_NEAR(texture.sample({0.375F, 0.625F}).r * 255.0F, 0.25F * 80.0F + 0.75F * 160.0F, 1e-3F);
}

TEST(Texture, RepeatMeetsTheOtherEdge) {
  const Texture texture = row({10, 50, 200, 100}, Wrap::repeat);
  EXPECT_NEAR(red_at(texture, 0.0F), 55.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1.0F), 55.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 3.375F), 50.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, -0.125F), 100.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, -1e-9F), 55.0F, 1e-4F);
}

TEST(Texture, ClampStaysAtItsEdge) {
  const Texture texture = row({10, 50, 200, 100}, Wrap::clamp_to_edge);
  EXPECT_NEAR(red_at(texture, 0.0F), 10.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, -7.0F), 10.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1.0F), 100.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1e30F), 100.0F, 1e-4F);
}

TEST(Texture, MirroredRepeatTurnsAround) {
  const Texture texture = row({10, 50, 200, 100}, Wrap::mirrored_repeat);
  EXPECT_NEAR(red_at(texture, 0.0F), 10.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1.0F), 100.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1.375F), 200.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, -0.375F), 50.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 2.375F), 50.0F, 1e-4F);
  EXPECT_NEAR(red_at(texture, 1.75F), 30.0F, 1e-4F);
}

TEST(Texture, WrapsEachAxisItsOwnWay) {
  const Texture texture(2, 2, {0, 0, 0, 255, 80, 0, 0, 255, 160, 0, 0, 255, 240, 0, 0, 255}, false,
                        Wrap::repeat, Wrap::clamp_to_edge);
  EXPECT_NEAR(texture.sample({1.25F, 1.75F}).r * 255.0F, 160.0F, 1e-4F);
}

/// IEC 61966-2-1, and the mid-grey whose value is commonly quoted.
TEST(Texture, DecodesSrgb) {
  const Texture texture = row({0, 10, 188, 255}, Wrap::repeat, true);
  EXPECT_EQ(texture.sample({0.125F, 0.5F}).r, 0.0F);
  EXPECT_NEAR(texture.sample({0.375F, 0.5F}).r, 10.0F / 255.0F / 12.92F, 1e-7F);
  EXPECT_NEAR(texture.sample({0.625F, 0.5F}).r, 0.502886F, 1e-5F);
  EXPECT_EQ(texture.sample({0.875F, 0.5F}).r, 1.0F);
}

TEST(Texture, InterpolatesLightNotCode) {
  const Texture texture = row({0, 255}, Wrap::clamp_to_edge, true);
  EXPECT_NEAR(texture.sample({0.5F, 0.5F}).g, 0.5F, 1e-6F);
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

}  // namespace
}  // namespace foveola
