#include "renderer/base/turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

TEST(Turns, SineAndCosineAreRightToTheLastBits) {
  for (int i = -300'000; i <= 300'000; ++i) {
    const float turns = static_cast<float>(i) / 200'000.0F;
    const auto [sine, cosine] = sine_cosine_of_turns(turns);
    ASSERT_NEAR(sine, std::sin(turn_rad * turns), 1.2e-7) << turns;
    ASSERT_NEAR(cosine, std::cos(turn_rad * turns), 1.2e-7) << turns;
  }
}

TEST(Turns, QuartersAreExact) {
  for (const float turns : {-1.0F, 0.0F, 1.0F, 1024.0F}) {
    EXPECT_EQ(sine_cosine_of_turns(turns).sine, 0.0F);
    EXPECT_EQ(sine_cosine_of_turns(turns).cosine, 1.0F);
    EXPECT_EQ(sine_cosine_of_turns(turns + 0.25F).sine, 1.0F);
    EXPECT_EQ(sine_cosine_of_turns(turns + 0.25F).cosine, 0.0F);
    EXPECT_EQ(sine_cosine_of_turns(turns + 0.5F).cosine, -1.0F);
    EXPECT_EQ(sine_cosine_of_turns(turns + 0.75F).sine, -1.0F);
  }
}

TEST(Turns, AnglesAreRightToTheLastBits) {
  Pcg32 random(3);
  for (int i = 0; i < 300'000; ++i) {
    const auto size = [&] { return std::pow(10.0, 8.0 * random.uniform() - 4.0); };
    const double y_size = size();
    const double x_size = size();
    const auto y = static_cast<float>(y_size * (2.0 * random.uniform() - 1.0));
    const auto x = static_cast<float>(x_size * (2.0 * random.uniform() - 1.0));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x)) / turn_rad;
    ASSERT_NEAR(turns_of(y, x), exact, std::min(4e-8, 4e-7 * std::abs(exact) + 1e-30))
        << y << ", " << x;
  }
}

TEST(Turns, AnglesOfTheAxes) {
  EXPECT_EQ(turns_of(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(turns_of(0.0F, 2.0F), 0.0F);
  EXPECT_EQ(turns_of(3.0F, 0.0F), 0.25F);
  EXPECT_EQ(turns_of(-3.0F, 0.0F), -0.25F);
  EXPECT_EQ(turns_of(0.0F, -1.0F), 0.5F);
  EXPECT_EQ(turns_of(-0.0F, -1.0F), -0.5F);
}

}  // namespace
}  // namespace foveola
