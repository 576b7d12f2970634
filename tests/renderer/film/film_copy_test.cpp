#include "renderer/film/film_copy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

class FilmCopyTest : public testing::Test {
 protected:
  /// What differs between copy and film in a tile, or is there although it should not be.
  int wrong_cells(std::uint32_t tile, bool is_copied) const {
    int wrong = 0;
    const IVec2 corner = film_.tile_corner(tile);
    for (int level = 0; level < FilmTile::levels; ++level) {
      for (int y = corner.y >> level; y < (corner.y + 32) >> level; ++y) {
        for (int x = corner.x >> level; x < (corner.x + 32) >> level; ++x) {
          const PremultipliedTexel expected =
              is_copied ? film_.cell(level, x, y) : PremultipliedTexel{};
          const PremultipliedTexel& cell = *copy_.cells().at(level, x, y);
          wrong += cell.color == expected.color && cell.weight == expected.weight ? 0 : 1;
        }
      }
    }
    return wrong;
  }

  const Workers workers_{2};
  EquirectFilm film_{256, 128};
  FilmCopy copy_{film_};
};

TEST_F(FilmCopyTest, HoldsTheTilesAskedForAndNoOther) {
  add_samples(sobol_samples(0, 5000), film_, workers_);
  copy_.refresh(std::vector<std::uint32_t>{3, 8, 31}, workers_);
  for (std::uint32_t tile = 0; tile < 32; ++tile) {
    EXPECT_EQ(wrong_cells(tile, tile == 3 || tile == 8 || tile == 31), 0) << tile;
  }
}

TEST_F(FilmCopyTest, IsBroughtUpToDateThroughChangesAndClears) {
  const std::vector<std::uint32_t> tiles = {9, 10, 17};
  for (std::uint64_t batch = 0; batch < 12; ++batch) {
    if (batch % 4 == 3) {
      film_.clear();
    }
    add_samples(sobol_samples(300 * batch, 300), film_, workers_);
    if (batch % 3 != 0) {
      copy_.refresh(tiles, workers_);
      for (const std::uint32_t tile : tiles) {
        EXPECT_EQ(wrong_cells(tile, true), 0) << "tile " << tile << ", batch " << batch;
      }
    }
  }
  film_.clear();
  copy_.refresh(tiles, workers_);
  for (const std::uint32_t tile : tiles) {
    EXPECT_EQ(wrong_cells(tile, false), 0) << tile;
  }
}

TEST_F(FilmCopyTest, CopiesWhatLiesAboveTiles) {
  add_samples(sobol_samples(0, 100), film_, workers_);
  copy_.refresh_above_tiles();
  for (int level = FilmTile::levels; level < film_.levels(); ++level) {
    for (int y = 0; y < film_.height(level); ++y) {
      for (int x = 0; x < film_.width(level); ++x) {
        EXPECT_EQ(copy_.cells().at(level, x, y)->color, film_.cell(level, x, y).color);
      }
    }
  }
  EXPECT_GT(copy_.cells().at(film_.levels() - 1, 0, 0)->weight, 0.0F);
}

/// Whether the trilinear mean at a position has a part in a cell, beyond the seam and the poles
/// too.
bool reads(const IVec2& film_size, const DVec2& image, double level, int cell_level,
           const IVec2& cell) {
  if (std::abs(level - cell_level) >= 1.0) {
    return false;
  }
  const IVec2 size = film_size / (1 << cell_level);
  const DVec2 place = image * DVec2(size) - 0.5;
  for (const int down : {0, 1}) {
    for (const int right : {0, 1}) {
      IVec2 at = IVec2(glm::floor(place)) + IVec2(right, down);
      if (at.y < 0 || at.y >= size.y) {
        at.y = at.y < 0 ? 0 : size.y - 1;
        at.x += size.x / 2;
      }
      at.x = (at.x + size.x) % size.x;
      if (at == cell) {
        return true;
      }
    }
  }
  return false;
}

class SquareChangesTest : public testing::Test {
 protected:
  static constexpr IVec2 film_size{128, 64};

  /// Eight positions at one height and level.
  static ViewPoints points_at(float u, float v, float level) {
    ViewPoints points = {.image = {all_lanes(u), all_lanes(v)}, .level = all_lanes(level)};
    for (std::size_t i = 0; i < lane_count; ++i) {
      points.image.x[i] = std::fmod(u + 0.0043F * static_cast<float>(i), 1.0F);
    }
    return points;
  }
};

TEST_F(SquareChangesTest, NoMeanThatReadsAChangedCellIsMissed) {
  Pcg32 random(1);
  int found = 0;
  int marked = 0;
  for (int round = 0; round < 20'000; ++round) {
    // At the sides more often than elsewhere; a pixel's change is its cell of level 1's.
    const int level = 1 + round % 4;
    const IVec2 size = film_size / (1 << level);
    const auto along = [&](int side) {
      const double place = random.uniform();
      return place < 0.2 ? 0 : place > 0.8 ? side - 1 : static_cast<int>(place * side);
    };
    const int x = along(size.x);
    const IVec2 cell(x, along(size.y));
    SquareChanges changes(film_size.x, film_size.y);
    changes.note(level, cell.x, cell.y, 7);
    const auto u = static_cast<float>((cell.x + 3.0 * random.uniform() - 1.5) / size.x);
    const auto v = static_cast<float>((cell.y + 3.0 * random.uniform() - 1.0) / size.y);
    const auto seen_level = static_cast<float>(level - 0.999 * random.uniform());
    const ViewPoints points =
        points_at(u - std::floor(u), std::fmin(std::fmax(v, 0.0F), 1.0F), seen_level);
    const std::array<std::uint32_t, lane_count> squares = changes.squares(points);
    for (std::size_t i = 0; i < lane_count; ++i) {
      const bool is_marked = changes.changed_at(squares[i]) == 7;
      marked += is_marked ? 1 : 0;
      if (reads(film_size, {points.image.x[i], points.image.y[i]}, seen_level, level, cell)) {
        ASSERT_TRUE(is_marked) << "level " << level << " at " << cell.x << ", " << cell.y
                               << " from " << points.image.x[i] << ", " << points.image.y[i];
        ++found;
      }
    }
  }
  EXPECT_GT(found, 20'000);
  EXPECT_EQ(marked, found);
}

// One pixel's, on all four levels: readers of level 0 alone get to know of its four neighbours
// too.
TEST_F(SquareChangesTest, PixelsChangeWithTheirCellOfTheFirstLevel) {
  SquareChanges changes(film_size.x, film_size.y);
  changes.note(1, 30, 20, 3);
  const auto changed_at = [&](float x, float y) {
    const Vec2 image = Vec2(x, y) / Vec2(film_size);
    return changes.changed_at(changes.squares(points_at(image.x, image.y, 0.0F)).front());
  };
  EXPECT_EQ(changed_at(61.0F, 41.0F), 3U);
  EXPECT_EQ(changed_at(59.1F, 39.1F), 3U);
  EXPECT_EQ(changed_at(62.9F, 42.9F), 3U);
  EXPECT_EQ(changed_at(64.1F, 41.0F), 0U);
  EXPECT_EQ(changed_at(61.0F, 38.0F), 0U);
}

}  // namespace

}  // namespace foveola
