// What a copy of the film has to be updated with: the changes that the display shows, and no
// others.
#pragma once

#include <span>
#include <vector>

#include "renderer/film/equirect_film.h"
#include "renderer/view/viewport.h"
#include "renderer/window/pyramid_atlas.h"

namespace foveola {

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
