#include "study/participant/observer/cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"

namespace foveola::study {
namespace {

const Vec3 object = direction_from({.azimuth_rad = 2.9, .elevation_rad = 0.6});

Vec3 any_direction(Pcg32& random) {
  return direction_from({.azimuth_rad = std::numbers::pi * (2.0 * random.uniform() - 1.0),
                         .elevation_rad = std::asin(2.0 * random.uniform() - 1.0)});
}

std::uint32_t cells_of_all_patches(const Cells& cells) {
  return std::accumulate(
      cells.patches().begin(), cells.patches().end(), 0U,
      [](std::uint32_t sum, const Cells::Patch& patch) { return sum + patch.cells; });
}

/// The largest angle between a direction of a cell and its patch.
double farthest_from_patch_deg(const Cells& cells) {
  Pcg32 random(3);
  double farthest_deg = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 direction = any_direction(random);
    const std::uint32_t cell = cells.at(direction);
    if (cell != Cells::none) {
      const Vec3& patch = cells.patches()[cells.patch_of(cell)].direction;
      farthest_deg = std::max(farthest_deg, degrees(angle_between(direction, patch)));
    }
  }
  return farthest_deg;
}

TEST(CellsAround, CoverADiscWithSquaresOfTheirSize) {
  constexpr double radius_deg = 6.0;
  constexpr double cell_deg = 0.5;
  const Cells cells = Cells::around(object, radius_deg, cell_deg, 2.0);
  // The disc's area on the tangent plane over a square's, within a ring of half a cell.
  const double radius_cells = std::tan(radians(radius_deg)) / radians(cell_deg);
  EXPECT_NEAR(static_cast<double>(cells.count()), std::numbers::pi * radius_cells * radius_cells,
              std::numbers::pi * radius_cells);
  EXPECT_EQ(cells_of_all_patches(cells), cells.count());
  EXPECT_LT(farthest_from_patch_deg(cells), 0.5 * 2.0 * std::numbers::sqrt2 + 0.6);
}

TEST(CellsAround, BelongToWhatIsNearAndNotToWhatIsFar) {
  const Cells cells = Cells::around(object, 6.0, 0.5, 2.0);
  Pcg32 random(4);
  int inside = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec3 direction = any_direction(random);
    const double away_deg = degrees(angle_between(direction, object));
    if (away_deg < 6.0 - 0.36) {
      EXPECT_NE(cells.at(direction), Cells::none);
      ++inside;
    } else if (away_deg > 6.0 + 0.36) {
      EXPECT_EQ(cells.at(direction), Cells::none);
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_EQ(cells.at(-object), Cells::none);
}

TEST(CellsAround, ThereAreSomeForTheSmallestObject) {
  EXPECT_EQ(Cells::around(object, 0.01, 0.5, 2.0).count(), 4U);
}

TEST(CellsAround, BlocksAreWholeButAtTheEdge) {
  const Cells cells = Cells::around(object, 12.0, 0.5, 2.0, 3);
  std::uint32_t in_whole_blocks = 0;
  std::uint32_t in_blocks = 0;
  for (const Cells::Block& block : cells.blocks()) {
    EXPECT_LE(block.cells, 9U);
    in_blocks += block.cells;
    in_whole_blocks += block.cells == 9 ? 9 : 0;
  }
  EXPECT_EQ(in_blocks, cells.count());
  EXPECT_GT(in_whole_blocks, 0.8 * in_blocks);
  EXPECT_GT(cells.patches().size(), 100U) << "of 1.5 degrees, not much larger";
}

TEST(CellMeans, AreThoseOfThePixelsThatLieInTheCell) {
  constexpr int size = 120;
  const Viewport viewport(head_orientation(azimuth_elevation(object)), radians(40.0),
                          radians(40.0));
  const Cells cells = Cells::around(object, 8.0, 4.0, 4.0);
  const CellPixels pixels = pixels_of(cells, viewport, size, size);
  // Left half dark, right half bright: the object's cells lie on one side or the other.
  RgbImage image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      image.at(x, y) = Rgb(x < size / 2 ? 0.25F : 0.75F);
    }
  }
  const std::vector<ChannelValues> means = cell_means(image, pixels, 1.0);
  ASSERT_EQ(means.size(), cells.count());
  const double dark = opponent_channels(Rgb(0.25F), 1.0)[0];
  const double bright = opponent_channels(Rgb(0.75F), 1.0)[0];
  int of_dark = 0;
  for (std::size_t cell = 0; cell < means.size(); ++cell) {
    EXPECT_GT(pixels.pixels_in_cell[cell], 100U);
    of_dark += std::abs(means[cell][0] - dark) < 1e-3 ? 1 : 0;
    EXPECT_NEAR(std::min(std::abs(means[cell][0] - dark), std::abs(means[cell][0] - bright)), 0.0,
                1e-3);
  }
  EXPECT_EQ(2 * of_dark, static_cast<int>(cells.count()));
}

TEST(CellMeans, WhatIsOutOfViewHasNoPixels) {
  const Viewport away(head_orientation(azimuth_elevation(-object)), radians(90.0), radians(90.0));
  const CellPixels pixels = pixels_of(Cells::around(object, 5.0, 1.0, 2.0), away, 32, 32);
  EXPECT_TRUE(pixels.members.empty());
}

}  // namespace
}  // namespace foveola::study
