// Computes updates of a film's copy, restricted to visible changes, and the layout of the pyramid's
// levels in one image, as on the graphics card.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/texel_pyramid.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Level 0 is at the top left; the others are in a row below it, in order.
class PyramidAtlas {
 public:
  struct Level {
    IVec2 origin{0};  ///< the cell (0, 0)
    IVec2 size{0};    ///< cells
  };

  PyramidAtlas() = default;
  /// The atlas of a film of width x height pixels, with all its levels; the last is a single cell.
  PyramidAtlas(int width, int height);

  const IVec2& size() const { return size_; }
  const std::vector<Level>& levels() const { return levels_; }

 private:
  IVec2 size_{0};
  std::vector<Level> levels_;
};

/// A rectangle of the atlas to fill with one value.
struct AtlasRectangle {
  std::uint16_t x = 0;  ///< column of its top left cell
  std::uint16_t y = 0;
  std::uint16_t width = 1;  ///< cells
  std::uint16_t height = 1;
  PremultipliedTexel value;
};

/// In order: later rectangles overwrite earlier ones.
using FilmUpdate = std::vector<AtlasRectangle>;

/// Tracks the age of a film pyramid's copy, tile by tile, and updates it where it is visible. Tiles
/// out of view are left until they come into it.
class FilmMirror {
 public:
  /// The copy is initially empty. film: at most 65535 pixels wide.
  explicit FilmMirror(const EquirectFilm& film);

  /// The update after which all cells of the levels [0, levels) visible in `viewports` equal those
  /// of `film`, which is the same in all calls.
  FilmUpdate collect(const EquirectFilm& film, std::span<const Viewport> viewports, int levels);

  const PyramidAtlas& atlas() const { return atlas_; }

 private:
  /// The state of a tile's copy.
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

/// Number of levels read for a view of `view` pixels, at least two.
int levels_shown(const Viewport& viewport, const IVec2& view, int film_height);

}  // namespace foveola
