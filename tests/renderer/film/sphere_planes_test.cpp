#include "renderer/film/sphere_planes.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

/// A value that distinguishes every place from every other.
int number_of(int level, int x, int y) { return 1 + x + 1000 * (y + 1000 * level); }

TEST(SpherePlanes, HoldWhatWasSetAndCopiesBeyondTheSeamAndThePoles) {
  for (const auto& [width, height] : {std::pair{64, 32}, {10, 5}, {3, 2}, {1, 1}}) {
    SpherePlanes<int> planes(width, height, 3);
    for (int level = 0; level < 3; ++level) {
      for (int y = 0; y < planes.height(level); ++y) {
        for (int x = 0; x < planes.width(level); ++x) {
          planes.set(level, x, y, number_of(level, x, y));
        }
      }
    }
    for (int level = 0; level < 3; ++level) {
      const int across = planes.width(level);
      const int down = planes.height(level);
      for (int y = -1; y <= down; ++y) {
        for (int x = -1; x <= across; ++x) {
          const bool over_pole = y < 0 || y == down;
          const int row = y < 0 ? 0 : y == down ? down - 1 : y;
          const int column = (x + across + (over_pole ? across / 2 : 0)) % across;
          ASSERT_EQ(*planes.at(level, x, y), number_of(level, column, row))
              << width << "x" << height << ", level " << level << ": " << x << ", " << y;
          ASSERT_EQ(planes.at(level, 0, y) + x, planes.at(level, x, y));
        }
        if (y < down) {
          ASSERT_EQ(planes.at(level, 0, y) + planes.stride(level), planes.at(level, 0, y + 1));
        }
      }
    }
  }
}

TEST(SpherePlanes, AreHalfAsLargeLevelByLevelRoundedUp) {
  const SpherePlanes<float> planes(100, 50, 4);
  EXPECT_EQ(planes.levels(), 4);
  EXPECT_EQ(planes.width(3), 13);
  EXPECT_EQ(planes.height(3), 7);
}

TEST(SpherePlanes, AreZeroAtFirst) {
  const SpherePlanes<float> planes(65536, 32768, 3);  // 11 gigabytes if it were all there
  EXPECT_EQ(*planes.at(0, 65536, 32768), 0.0F);
  EXPECT_EQ(*planes.at(2, -1, -1), 0.0F);
}

}  // namespace
}  // namespace foveola
