// What a copy of the film has to be updated with: the changes that the display shows, and no
// others; and the levels of its pyramid side by side in one image, as the graphics card keeps them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/texel_pyramid.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Level 0 stands at the top left; the others stand in a row below it, in their order.
class PyramidAtlas {
 public:
  struct Level {
    IVec2 origin{0};  ///< where its cell (0, 0) lies
    IVec2 size{0};    ///< cells
  };

  PyramidAtlas() = default;
  /// The atlas of a film of width x height pixels: as many levels as it has, the last a single
  /// cell.
  PyramidAtlas(int width, int height);

  const IVec2& size() const { return size_; }
  const std::vector<Level>& levels() const { return levels_; }

 private:
  IVec2 size_{0};
  std::vector<Level> levels_;
};

/// Gives all cells of a rectangle of the atlas one value.
struct AtlasRectangle {
  std::uint16_t x = 0;  ///< column of its top left cell
  std::uint16_t y = 0;
  std::uint16_t width = 1;  ///< cells
  std::uint16_t height = 1;
  PremultipliedTexel value;
};

/// In order: later rectangles lie over earlier ones.
using FilmUpdate = std::vector<AtlasRectangle>;

/// Knows how old a copy of a film's pyramid is, tile by tile, and brings it up to date where it is
/// seen. Tiles out of view stay as they are until they come into it.
class FilmMirror {
 public:
  /// The copy has no samples at first. film: at most 65535 pixels wide.
  explicit FilmMirror(const EquirectFilm& film);

  /// What to write into the copy so that all cells of the levels [0, levels) that `viewports` show
  /// are as those of `film`, which is always the same one.
  FilmUpdate collect(const EquirectFilm& film, std::span<const Viewport> viewports, int levels);

  const PyramidAtlas& atlas() const { return atlas_; }

 private:
  /// What is known of a tile.
  struct Copy {
    FilmRevision revision = 0;
    int levels = 0;  ///< [0, levels) are of that revision
  };

  void bring_up_to_date(const EquirectFilm& film, std::uint32_t tile, int levels,
                        FilmUpdate& update);
  void forget_tile(const EquirectFilm& film, std::uint32_t tile, FilmUpdate& update) const;
  void copy_coarse_levels(const EquirectFilm& film, int levels, FilmUpdate& update);
  AtlasRectangle cell(int level, const IVec2& place, const PremultipliedTexel& value) const;

  PyramidAtlas atlas_;
  std::vector<Copy> copies_;
  FilmRevision coarse_revision_ = 0;
  int coarse_levels_ = 0;
};

/// How many levels a view of `view` pixels is read from, two at least.
int levels_shown(const Viewport& viewport, const IVec2& view, int film_height);

}  // namespace foveola
