#include "renderer/film/film_copy.h"

#include <atomic>

namespace foveola {
namespace {

/// Number of tiles that one task copies.
constexpr std::size_t tiles_in_task = 16;

}  // namespace

SquareChanges::SquareChanges(int width, int height) : size_(width, height) {
  std::uint32_t first = 0;
  for (int level = 1; level < FilmTile::levels; ++level) {
    Level& at = levels_[static_cast<std::size_t>(level)];
    at = {first, (width + (1 << level) - 1) >> level, (height + (1 << level) - 1) >> level};
    first = at.number(at.width - 1, at.height - 1) + 1;
  }
  changed_at_ = make_lazy_array<FilmRevision>(first);
}

void SquareChanges::note(int level, int x, int y, FilmRevision revision) {
  const Level& at = levels_[static_cast<std::size_t>(level)];
  note_in_row(at, x, y - 1, revision);
  note_in_row(at, x, y, revision);
  // Beyond a pole the same row continues half an image further.
  const int opposite = (x + at.width - at.width / 2) % at.width;
  if (y == 0) {
    note_in_row(at, opposite, -1, revision);
  }
  if (y == at.height - 1) {
    note_in_row(at, opposite, y, revision);
  }
}

void SquareChanges::note_in_row(const Level& level, int x, int row, FilmRevision revision) {
  const auto note_square = [&](int column) {
    // Tiles share the squares at their sides; threads that copy them all write the same value.
    const std::atomic_ref<FilmRevision> changed_at(changed_at_[level.number(column, row)]);
    changed_at.store(revision, std::memory_order_relaxed);
  };
  note_square(x - 1);
  note_square(x);
  if (x == 0) {
    note_square(level.width - 1);
  }
  if (x == level.width - 1) {
    note_square(-1);
  }
}

std::array<std::uint32_t, lane_count> SquareChanges::squares(const ViewPoints& points) const {
  // Cells of the coarser level contain those of the finer one, and changes begin at level 1.
  const Ints finer = truncated(points.level);
  const Ints coarser = finer - (points.level > floats_of(finer));
  const Ints level = coarser - (coarser < 1);
  const CellsAround at = cells_around(size_, points.image, level);
  std::array<std::uint32_t, lane_count> numbers;
  for (std::size_t i = 0; i < lane_count; ++i) {
    numbers[i] = levels_[static_cast<std::size_t>(level[i])].number(at.x[i], at.y[i]);
  }
  return numbers;
}

FilmCopy::FilmCopy(const EquirectFilm& film)
    : film_(&film),
      cells_(film.width(), film.height(), film.levels()),
      changes_(film.width(), film.height()),
      copied_at_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {}

void FilmCopy::refresh(std::span<const std::uint32_t> tiles, const Workers& workers) {
  workers.for_each_block(tiles.size(), tiles_in_task, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t tile : tiles.subspan(begin, end - begin)) {
      refresh(tile);
    }
  });
}

void FilmCopy::refresh(std::uint32_t tile) {
  const FilmRevision since = copied_at_[tile];
  if (film_->tile_changed_at(tile) <= since) {
    return;
  }
  if (since > 0 && since < film_->cleared_at()) {
    empty(tile);
  }
  const FilmRevision now = film_->revision();
  film_->for_each_changed_cell(tile, since,
                               [&](int level, const IVec2& cell, const PremultipliedTexel& texel) {
                                 cells_.set(level, cell.x, cell.y, texel);
                                 if (level > 0) {
                                   changes_.note(level, cell.x, cell.y, now);
                                 }
                               });
  copied_at_[tile] = now;
}

void FilmCopy::empty(std::uint32_t tile) {
  const IVec2 corner = film_->tile_corner(tile);
  for (int level = 0; level < FilmTile::levels; ++level) {
    const int size = FilmTile::size >> level;
    const IVec2 begin(corner.x >> level, corner.y >> level);
    const IVec2 end = glm::min(begin + size, IVec2(cells_.width(level), cells_.height(level)));
    for (int y = begin.y; y < end.y; ++y) {
      for (int x = begin.x; x < end.x; ++x) {
        cells_.set(level, x, y, {});
      }
    }
  }
}

void FilmCopy::refresh_above_tiles() {
  for (int level = FilmTile::levels; level < cells_.levels(); ++level) {
    for (int y = 0; y < cells_.height(level); ++y) {
      for (int x = 0; x < cells_.width(level); ++x) {
        cells_.set(level, x, y, film_->cell(level, x, y));
      }
    }
  }
}

}  // namespace foveola
