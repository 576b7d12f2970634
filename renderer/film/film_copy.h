// A copy of what a film's pyramid knows where it is looked at, laid out for reading, and when the
// cells that a view's pixels are made of last changed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/film_tile.h"
#include "renderer/film/shown_color.h"
#include "renderer/film/sphere_planes.h"

namespace foveola {

/// For each square of two by two cells, of the levels [1, FilmTile::levels) of a film's pyramid,
/// when one of the four last changed. A trilinear mean's cells all lie in such a square, where
/// twice a cell's width divides the film's and a cell's height the film's: of other films, cells of
/// two levels lie askew at the seam.
class SquareChanges {
 public:
  /// For a film of width x height pixels, nothing of which changed yet.
  SquareChanges(int width, int height);

  /// The cell at (x, y) of `level` changes at `revision`. May be called from many threads.
  void note(int level, int x, int y, FilmRevision revision);

  /// The numbers of the squares that eight pixels' trilinear means are made of.
  std::array<std::uint32_t, lane_count> squares(const ViewPoints& points) const;
  FilmRevision changed_at(std::uint32_t square) const { return changed_at_[square]; }

 private:
  /// Squares are named by the upper left of their cells, whose column and row are -1 or more.
  struct Level {
    std::uint32_t first;  ///< number of the square at (-1, -1)
    int width;
    int height;
    std::uint32_t number(int x, int y) const {
      return first + static_cast<std::uint32_t>(y + 1) * static_cast<std::uint32_t>(width + 1) +
             static_cast<std::uint32_t>(x + 1);
    }
  };
  /// The squares of a row that have cells of the column x.
  void note_in_row(const Level& level, int x, int row, FilmRevision revision);

  Vec2 size_;
  std::array<Level, FilmTile::levels> levels_;
  LazyArray<FilmRevision> changed_at_;
};

/// The film is made for samples, which fall anywhere; this for views, which read all of a region
/// again and again. Takes 23 bytes for each pixel of the tiles that were copied.
class FilmCopy {
 public:
  /// film must outlive this. The copy is empty until it is refreshed.
  explicit FilmCopy(const EquirectFilm& film);

  /// Brings these tiles up to date, each given once. They lack what is above them.
  void refresh(std::span<const std::uint32_t> tiles, const Workers& workers);
  /// Copies the levels from FilmTile::levels on, whole.
  void refresh_above_tiles();

  /// The cells of EquirectFilm::cell, where they were refreshed.
  const SpherePlanes<PremultipliedTexel>& cells() const { return cells_; }
  /// The film's revision when cells were copied; what a clear empties is not noted.
  const SquareChanges& changes() const { return changes_; }

 private:
  void refresh(std::uint32_t tile);
  void empty(std::uint32_t tile);

  const EquirectFilm* film_;
  SpherePlanes<PremultipliedTexel> cells_;
  SquareChanges changes_;
  std::vector<FilmRevision>
      copied_at_;  ///< each tile's revision when it was copied, 0 if it never was
};

}  // namespace foveola
