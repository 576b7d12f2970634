// What a film reports to those who keep a copy of it.
#include <cmath>
#include <map>
#include <tuple>

#include "renderer/film/equirect_film.h"
#include "tests/matchers.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

/// What a film says of its tiles' cells.
using Cells =
    std::map<std::tuple<int, int, int>, PremultipliedTexel>;  ///< keyed by level, row and column

Cells changed_cells(const EquirectFilm& film, FilmRevision since) {
  Cells cells;
  const auto tiles = static_cast<std::uint32_t>(film.tiles_across() * film.tiles_down());
  for (std::uint32_t tile = 0; tile < tiles; ++tile) {
    const auto visit = [&](int level, const IVec2& cell, const PremultipliedTexel& texel) {
      EXPECT_TRUE(cells.insert({{level, cell.y, cell.x}, texel}).second) << "visited twice";
      EXPECT_EQ(film.tile_of(cell.x << level, cell.y << level), tile);
      EXPECT_GT(film.tile_changed_at(tile), since);
    };
    film.for_each_changed_cell(tile, since, visit);
  }
  return cells;
}

/// Those of the levels that tiles have, which know something.
Cells known_cells(const EquirectFilm& film) {
  Cells cells;
  for (int level = 0; level < FilmTile::levels; ++level) {
    for (int y = 0; y < film.height(level); ++y) {
      for (int x = 0; x < film.width(level); ++x) {
        const PremultipliedTexel cell = film.cell(level, x, y);
        if (cell.weight > 0.0F) {
          cells[{level, y, x}] = cell;
        }
      }
    }
  }
  return cells;
}

void expect_same(const Cells& a, const Cells& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [place, texel] : a) {
    const auto other = b.find(place);
    ASSERT_NE(other, b.end());
    EXPECT_EQ(texel.color, other->second.color);
    EXPECT_EQ(texel.weight, other->second.weight);
  }
}

TEST(FilmChanges, NameEveryCellThatKnowsSomething) {
  const Workers workers(2);
  EquirectFilm film(300, 140);
  EXPECT_TRUE(changed_cells(film, 0).empty());
  add_samples(sobol_samples(0, 700), film, workers);
  expect_same(changed_cells(film, 0), known_cells(film));
  add_samples(sobol_samples(700, 9000), film, workers);
  expect_same(changed_cells(film, 0), known_cells(film));
}

TEST(FilmChanges, AreWhatLiesOverAndBesideAChange) {
  const Workers workers(1);
  EquirectFilm film(128, 64);
  add_samples(sobol_samples(0, 50'000), film, workers);
  const FilmRevision before = film.revision();
  EXPECT_TRUE(changed_cells(film, before).empty());
  add_samples(in_pixel(77, 41, film, 2), film, workers);
  EXPECT_GT(film.revision(), before);
  std::vector<std::tuple<int, int, int>> places;
  for (const auto& [place, texel] : changed_cells(film, before)) {
    places.push_back(place);
  }
  EXPECT_THAT(places, ElementsAre(FieldsAre(0, 40, 76), FieldsAre(0, 40, 77), FieldsAre(0, 41, 76),
                                  FieldsAre(0, 41, 77), FieldsAre(1, 20, 38), FieldsAre(2, 10, 19),
                                  FieldsAre(3, 5, 9), FieldsAre(4, 2, 4)));
  EXPECT_EQ(film.tile_changed_at(film.tile_of(77, 41)), film.revision());
  EXPECT_EQ(film.tile_changed_at(film.tile_of(10, 10)), before);
}

TEST(FilmChanges, AClearChangesEverything) {
  const Workers workers(1);
  EquirectFilm film(128, 64);
  add_samples(sobol_samples(0, 500), film, workers);
  EXPECT_EQ(film.cleared_at(), 0U);
  const FilmRevision before = film.revision();
  film.clear();
  EXPECT_GT(film.cleared_at(), before);
  EXPECT_EQ(film.revision(), film.cleared_at());
  for (std::uint32_t tile = 0; tile < 8; ++tile) {
    EXPECT_EQ(film.tile_changed_at(tile), film.cleared_at());
  }
  EXPECT_TRUE(changed_cells(film, 0).empty());
  add_samples(in_pixel(77, 41, film, 1), film, workers);
  EXPECT_GT(film.tile_changed_at(film.tile_of(77, 41)), film.cleared_at());
  expect_same(changed_cells(film, before), known_cells(film));
}

// Its radiance was not finite, so nothing knows of it.
TEST(FilmChanges, ADroppedSampleChangesNoCell) {
  const Workers workers(1);
  EquirectFilm film(64, 32);
  NumberedBatch batch;
  film.number(in_pixel(5, 7, film, 1), batch, workers);
  film.add(batch, std::vector<Rgb>{Rgb(std::nanf(""))}, workers);
  EXPECT_TRUE(changed_cells(film, 0).empty());
}

}  // namespace
}  // namespace foveola
