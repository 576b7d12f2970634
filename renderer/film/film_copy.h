// A copy of the viewed part of a film's pyramid, laid out for reading, with the revisions of its
// cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/film_tile.h"
#include "renderer/film/shown_color.h"
#include "renderer/film/sphere_planes.h"

namespace foveola {

/// The last change of each square of two by two cells, of the levels [1, FilmTile::levels) of a
/// film's pyramid. A trilinear mean's cells lie in one such square, if twice a cell's width divides
/// the film's and a cell's height the film's. In other films, cells of two levels are not aligned
/// at the seam.
class SquareChanges {
 public:
  /// For an unchanged film of width x height pixels.
  SquareChanges(int width, int height);

  /// Notes that the cell at (x, y) of `level` changes at `revision`. Thread-safe.
  void note(int level, int x, int y, FilmRevision revision);

  /// The squares of eight pixels' trilinear means.
  std::array<std::uint32_t, lane_count> squares(const ViewPoints& points) const;
  FilmRevision changed_at(std::uint32_t square) const { return changed_at_[square]; }

 private:
  /// Squares are numbered by their upper left cell, whose column and row are -1 or more.
  struct Level {
    std::uint32_t first;  ///< number of the square at (-1, -1)
    int width;
    int height;
    std::uint32_t number(int x, int y) const {
      return first + static_cast<std::uint32_t>(y + 1) * static_cast<std::uint32_t>(width + 1) +
             static_cast<std::uint32_t>(x + 1);
    }
  };
  /// Notes a change in the squares of a row that contain the column x.
  void note_in_row(const Level& level, int x, int row, FilmRevision revision);

  Vec2 size_;
  std::array<Level, FilmTile::levels> levels_;
  LazyArray<FilmRevision> changed_at_;
};

/// The film's layout suits scattered samples; this one suits views, which read all of a region
/// repeatedly. Takes 23 bytes for each pixel of the copied tiles.
class FilmCopy {
 public:
  /// film must outlive this. The copy is empty until its first refresh.
  explicit FilmCopy(const EquirectFilm& film);

  /// Updates these tiles, each given once; without the levels above tiles.
  void refresh(std::span<const std::uint32_t> tiles, const Workers& workers);
  /// Copies all levels from FilmTile::levels.
  void refresh_above_tiles();

  /// Copies of EquirectFilm::cell, where refreshed.
  const SpherePlanes<PremultipliedTexel>& cells() const { return cells_; }
  /// The film's revision when cells were copied; cells emptied by a clear are not noted.
  const SquareChanges& changes() const { return changes_; }

 private:
  void refresh(std::uint32_t tile);
  void empty(std::uint32_t tile);

  const EquirectFilm* film_;
  SpherePlanes<PremultipliedTexel> cells_;
  SquareChanges changes_;
  std::vector<FilmRevision> copied_at_;  ///< each tile's revision when it was copied; 0: never
};

}  // namespace foveola
