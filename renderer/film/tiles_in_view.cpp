#include "renderer/film/tiles_in_view.h"

#include <algorithm>
#include <array>

namespace foveola {
namespace {

constexpr int tile_side = EquirectFilm::tile_size;

/// Columns or rows. Of those within a tile's side of the tile that begins at `begin`, these lie in
/// all the tiles that there are: the last tile of the image may be narrower than others.
std::array<int, 5> ends_around(int begin) {
  return {begin - tile_side, begin - 1, begin, begin + tile_side, begin + 2 * tile_side - 1};
}

/// A mark for each tile of a film.
class TileMarks {
 public:
  explicit TileMarks(const EquirectFilm& film)
      : film_(film), marks_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {}

  void mark_around(std::uint32_t tile) {
    const IVec2 corner = film_.tile_corner(tile);
    const int last_row = film_.height() - 1;
    for (const int y : ends_around(corner.y)) {
      if (y < 0) {
        mark_rows(0, std::min(-1 - y, last_row));
      } else if (y > last_row) {
        mark_rows(std::max(2 * last_row + 1 - y, 0), last_row);
      } else {
        mark_columns_around(corner.x, y);
      }
    }
  }

  std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t tile = 0; tile < marks_.size(); ++tile) {
      if (marks_[tile] != 0) {
        numbers.push_back(tile);
      }
    }
    return numbers;
  }

 private:
  /// All tiles with pixels in the rows [first, last].
  void mark_rows(int first, int last) {
    std::fill(marks_.begin() + film_.tile_of(0, first),
              marks_.begin() + film_.tile_of(film_.width() - 1, last) + 1, char{1});
  }
  void mark_columns_around(int begin, int y) {
    for (const int x : ends_around(begin)) {
      // Images narrower than a tile are passed around more than once.
      const int wrapped = (x % film_.width() + film_.width()) % film_.width();
      marks_[film_.tile_of(wrapped, y)] = 1;
    }
  }

  const EquirectFilm& film_;
  std::vector<char> marks_;
};

}  // namespace

TilesInView::TilesInView(const EquirectFilm& film)
    : film_(&film),
      size_(Vec2(film.width(), film.height()) / static_cast<float>(tile_side)),
      last_(film.tiles_across() - 1, film.tiles_down() - 1),
      is_marked_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {}

void TilesInView::forget() {
  for (std::atomic<bool>& mark : is_marked_) {
    mark.store(false, std::memory_order_relaxed);
  }
}

void TilesInView::mark(const Vec2s& image) {
  const Ints column = truncated(smaller(image.x * size_.x, last_.x));
  const Ints row = truncated(smaller(image.y * size_.y, last_.y));
  const Ints tiles = row * film_->tiles_across() + column;
  std::int32_t marked = -1;
  for (std::size_t i = 0; i < lane_count; ++i) {
    // Neighbours mostly lie in the same one.
    if (tiles[i] != marked) {
      marked = tiles[i];
      is_marked_[static_cast<std::size_t>(marked)].store(true, std::memory_order_relaxed);
    }
  }
}

std::vector<std::uint32_t> TilesInView::around() const {
  TileMarks marks(*film_);
  for (std::uint32_t tile = 0; tile < is_marked_.size(); ++tile) {
    if (is_marked_[tile].load(std::memory_order_relaxed)) {
      marks.mark_around(tile);
    }
  }
  return marks.numbers();
}

}  // namespace foveola
