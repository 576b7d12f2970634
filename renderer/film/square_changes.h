// When the cells that a view's pixels are made of last changed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/film/film_tile.h"
#include "renderer/film/lazy_array.h"
#include "renderer/film/shown_color.h"

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

}  // namespace foveola
