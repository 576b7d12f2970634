#include "renderer/window/pyramid_atlas.h"

#include <vector>

#include <gtest/gtest.h>

#include "renderer/film/equirect_film.h"

namespace foveola {
namespace {

TEST(PyramidAtlasTest, LevelsAreTheFilms) {
  for (const IVec2 size : {IVec2(64, 32), IVec2(100, 50), IVec2(1, 1), IVec2(7, 65)}) {
    const EquirectFilm film(size.x, size.y);
    const PyramidAtlas atlas(size.x, size.y);
    ASSERT_EQ(static_cast<int>(atlas.levels().size()), film.levels()) << size.x << 'x' << size.y;
    for (int level = 0; level < film.levels(); ++level) {
      EXPECT_EQ(atlas.levels()[level].size, IVec2(film.width(level), film.height(level)));
    }
  }
}

TEST(PyramidAtlasTest, LevelsLieApartAndInside) {
  for (const IVec2 size : {IVec2(64, 32), IVec2(100, 50), IVec2(3, 1), IVec2(7, 65)}) {
    const PyramidAtlas atlas(size.x, size.y);
    std::vector<int> uses(static_cast<std::size_t>(atlas.size().x) * atlas.size().y);
    for (const PyramidAtlas::Level& level : atlas.levels()) {
      for (int y = 0; y < level.size.y; ++y) {
        for (int x = 0; x < level.size.x; ++x) {
          const IVec2 at = level.origin + IVec2(x, y);
          ASSERT_LT(at.x, atlas.size().x);
          ASSERT_LT(at.y, atlas.size().y);
          EXPECT_EQ(++uses[static_cast<std::size_t>(at.y) * atlas.size().x + at.x], 1);
        }
      }
    }
  }
}

TEST(PyramidAtlasTest, TakesHalfAsMuchAgain) {
  EXPECT_EQ(PyramidAtlas(4096, 2048).size(), IVec2(4096, 3072));
}

}  // namespace
}  // namespace foveola
