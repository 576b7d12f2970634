#include "renderer/window/drawing/film_mirror.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "renderer/film/film_tile.h"
#include "renderer/film/view_pixels.h"
#include "renderer/view/image_samplers.h"

namespace foveola {
namespace {

/// Rows and columns of tiles, some of them marked.
struct MarkedTiles {
  std::vector<bool> columns;
  std::vector<bool> rows;
};

/// The tiles in `viewport` and, since cells are read with their neighbours, those less than a tile
/// beside it.
MarkedTiles tiles_in(const Viewport& viewport, const EquirectFilm& film) {
  const ImageRectangle seen = bounding_rectangle(viewport);
  const int margin = EquirectFilm::tile_size;
  const auto pixel = [](double position, int size) {
    return static_cast<int>(std::floor(position * size));
  };
  MarkedTiles tiles{.columns = std::vector<bool>(static_cast<std::size_t>(film.tiles_across())),
                    .rows = std::vector<bool>(static_cast<std::size_t>(film.tiles_down()))};
  const int top = pixel(seen.v_begin, film.height()) - margin;
  const int bottom = pixel(seen.v_end, film.height()) + margin;
  for (int y = std::max(top, 0); y <= std::min(bottom, film.height() - 1); ++y) {
    tiles.rows[static_cast<std::size_t>(y / EquirectFilm::tile_size)] = true;
  }
  // Beyond a pole the neighbours lie half an image away.
  const bool has_pole = top < 0 || bottom >= film.height();
  const int left = has_pole ? 0 : pixel(seen.u_begin, film.width()) - margin;
  const int right =
      has_pole ? film.width() : pixel(seen.u_begin + seen.width, film.width()) + margin;
  for (int x = left; x <= right; ++x) {
    const int wrapped = ((x % film.width()) + film.width()) % film.width();
    tiles.columns[static_cast<std::size_t>(wrapped / EquirectFilm::tile_size)] = true;
  }
  return tiles;
}

}  // namespace

PyramidAtlas::PyramidAtlas(int width, int height) {
  assert(width > 0 && height > 0);
  IVec2 size(width, height);
  levels_.push_back({.origin = IVec2(0), .size = size});
  size_ = size;
  int right = 0;
  while (size != IVec2(1) || levels_.size() <= FilmTile::levels) {
    size = (size + 1) / 2;
    levels_.push_back({.origin = IVec2(right, height), .size = size});
    right += size.x;
    size_ = glm::max(size_, IVec2(right, height + size.y));
  }
}

FilmMirror::FilmMirror(const EquirectFilm& film)
    : atlas_(film.width(), film.height()),
      copies_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {
  assert(std::max(atlas_.size().x, atlas_.size().y) <= std::numeric_limits<std::uint16_t>::max());
}

FilmUpdate FilmMirror::collect(const EquirectFilm& film, std::span<const Viewport> viewports,
                               int levels) {
  FilmUpdate update;
  for (const Viewport& viewport : viewports) {
    const MarkedTiles seen = tiles_in(viewport, film);
    for (std::uint32_t tile = 0; tile < copies_.size(); ++tile) {
      if (seen.columns[tile % seen.columns.size()] && seen.rows[tile / seen.columns.size()]) {
        bring_up_to_date(film, tile, std::min(levels, FilmTile::levels), update);
      }
    }
  }
  copy_coarse_levels(film, std::min(levels, film.levels()), update);
  return update;
}

void FilmMirror::bring_up_to_date(const EquirectFilm& film, std::uint32_t tile, int levels,
                                  FilmUpdate& update) {
  Copy& copy = copies_[tile];
  const bool has_levels = copy.levels >= levels;
  if (has_levels && copy.revision >= film.tile_changed_at(tile)) {
    copy.levels = levels;
    return;
  }
  const bool is_void = copy.revision < film.cleared_at();
  if (is_void && copy.levels > 0) {
    forget_tile(film, tile, update);
  }
  film.for_each_changed_cell(tile, is_void || !has_levels ? 0 : copy.revision,
                             [&](int level, const IVec2& place, const PremultipliedTexel& value) {
                               if (level < levels) {
                                 update.push_back(cell(level, place, value));
                               }
                             });
  copy = {.revision = film.revision(), .levels = levels};
}

void FilmMirror::forget_tile(const EquirectFilm& film, std::uint32_t tile,
                             FilmUpdate& update) const {
  const IVec2 corner = film.tile_corner(tile);
  for (int level = 0; level < FilmTile::levels; ++level) {
    const IVec2 first = corner >> level;
    const IVec2 end = glm::min(first + (EquirectFilm::tile_size >> level),
                               atlas_.levels()[static_cast<std::size_t>(level)].size);
    AtlasRectangle all = cell(level, first, {});
    all.width = static_cast<std::uint16_t>(end.x - first.x);
    all.height = static_cast<std::uint16_t>(end.y - first.y);
    update.push_back(all);
  }
}

void FilmMirror::copy_coarse_levels(const EquirectFilm& film, int levels, FilmUpdate& update) {
  if (levels <= FilmTile::levels ||
      (film.revision() == coarse_revision_ && coarse_levels_ >= levels)) {
    return;
  }
  for (int level = FilmTile::levels; level < levels; ++level) {
    for (int y = 0; y < film.height(level); ++y) {
      for (int x = 0; x < film.width(level); ++x) {
        update.push_back(cell(level, {x, y}, film.cell(level, x, y)));
      }
    }
  }
  coarse_revision_ = film.revision();
  coarse_levels_ = levels;
}

AtlasRectangle FilmMirror::cell(int level, const IVec2& place,
                                const PremultipliedTexel& value) const {
  const IVec2 at = atlas_.levels()[static_cast<std::size_t>(level)].origin + place;
  return {
      .x = static_cast<std::uint16_t>(at.x), .y = static_cast<std::uint16_t>(at.y), .value = value};
}

int levels_shown(const Viewport& viewport, const IVec2& view, int film_height) {
  // The largest pixel is on the lens' axis or, under some lenses, at the edge.
  constexpr int steps = 16;
  double largest_sr = viewport.sr_per_area(viewport.lens().axis);
  for (int y = 0; y <= steps; ++y) {
    for (int x = 0; x <= steps; ++x) {
      largest_sr =
          std::max(largest_sr, viewport.sr_per_area(Vec2(x, y) / static_cast<float>(steps)));
    }
  }
  const double pixels = static_cast<double>(view.x) * view.y;
  return 2 + static_cast<int>(level_for(largest_sr / pixels, film_height));
}

}  // namespace foveola
