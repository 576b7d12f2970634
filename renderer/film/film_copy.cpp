#include "renderer/film/film_copy.h"

namespace foveola {
namespace {

/// Tiles that one task copies.
constexpr std::size_t tiles_in_task = 16;

}  // namespace

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
