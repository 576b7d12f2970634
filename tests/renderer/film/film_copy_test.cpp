#include "renderer/film/film_copy.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace foveola
