#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/gaze/device_clocks.h"

namespace foveola {
namespace {

TEST(SlidingMinimum, IsThatOfTheWindow) {
  constexpr int window = 20;
  SlidingMinimum<std::uint32_t> minimum{Nanoseconds(window)};
  Pcg32 random(3);
  std::vector<std::uint32_t> values;
  for (int time = 0; time < 1000; ++time) {
    values.push_back(random.below(1000));
    minimum.add(Nanoseconds(time), values.back());
    const auto first = values.begin() + std::max(0, time - window);
    ASSERT_EQ(minimum.least(), *std::min_element(first, values.end())) << time;
  }
}

TEST(SlidingMinimum, ForgetsAllWhenCleared) {
  SlidingMinimum<int> minimum(std::chrono::seconds(1));
  minimum.add(Nanoseconds(0), 1);
  minimum.clear();
  minimum.add(Nanoseconds(1), 5);
  EXPECT_EQ(minimum.least(), 5);
}

}  // namespace
}  // namespace foveola
