#include "renderer/film/tiles_in_view.h"

#include <algorithm>

#include "tests/matchers.h"

namespace foveola {
namespace {

/// Eight times the same.
Vec2s middle_of(const EquirectFilm& film, int x, int y) {
  const Vec2 image = (Vec2(x, y) + 0.5F) / Vec2(film.width(), film.height());
  return {all_lanes(image.x), all_lanes(image.y)};
}

/// Where a pixel that may lie beyond the seam or a pole is.
IVec2 on_sphere(const EquirectFilm& film, IVec2 pixel) {
  if (pixel.y < 0 || pixel.y >= film.height()) {
    pixel.y = pixel.y < 0 ? -1 - pixel.y : 2 * film.height() - 1 - pixel.y;
    pixel.x += film.width() / 2;
  }
  return {(pixel.x % film.width() + film.width()) % film.width(), pixel.y};
}

// Films of whole tiles, and of narrow ones at the right and the bottom.
TEST(TilesInView, HoldEverythingWithinATileOfAMark) {
  for (const IVec2& size : {IVec2(256, 128), IVec2(100, 50), IVec2(70, 33), IVec2(20, 40)}) {
    const EquirectFilm film(size.x, size.y);
    for (int y = 0; y < size.y; y += 7) {
      for (int x = 0; x < size.x; x += 5) {
        TilesInView view(film);
        view.mark(middle_of(film, x, y));
        const std::vector<std::uint32_t> tiles = view.around();
        for (const int dy : {-31, -24, -1, 0, 1, 24, 31}) {
          for (const int dx : {-31, -24, -1, 0, 1, 24, 31}) {
            const IVec2 near = on_sphere(film, IVec2(x + dx, y + dy));
            ASSERT_TRUE(
                std::binary_search(tiles.begin(), tiles.end(), film.tile_of(near.x, near.y)))
                << size.x << "x" << size.y << ": " << near.x << ", " << near.y << " from " << x
                << ", " << y;
          }
        }
      }
    }
  }
}

TEST(TilesInView, LeaveOutWhatIsFurtherAway) {
  const EquirectFilm film(512, 256);
  TilesInView view(film);
  EXPECT_THAT(view.around(), IsEmpty());
  view.mark(middle_of(film, 100, 100));
  EXPECT_THAT(view.around(), ElementsAre(34, 35, 36, 50, 51, 52, 66, 67, 68));
  view.forget();
  EXPECT_THAT(view.around(), IsEmpty());
  view.mark(middle_of(film, 511, 100));
  EXPECT_THAT(view.around(), ElementsAre(32, 46, 47, 48, 62, 63, 64, 78, 79));
}

}  // namespace
}  // namespace foveola
