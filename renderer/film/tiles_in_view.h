// Which tiles of a film a view is made from.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/film/equirect_film.h"

namespace foveola {

/// Marks the tiles that a view's pixels lie in, and finds what lies around them.
class TilesInView {
 public:
  /// film must outlive this.
  explicit TilesInView(const EquirectFilm& film);

  void forget();
  /// Marks the tiles at eight positions on the image. May be called from many threads.
  void mark(const Vec2s& image);

  /// Returns, in ascending order and without repetition, the tiles of which some pixel is less than
  /// a tile's side to the left, right, above or below of one in a marked tile, beyond the seam and
  /// the poles too (there perhaps some more). Every cell that fewer than FilmTile::levels levels
  /// blend at a marked position is in them: it reaches 24 pixels at most.
  std::vector<std::uint32_t> around() const;

 private:
  const EquirectFilm* film_;
  Vec2 size_;                                 ///< the image's size in tiles
  Vec2 last_;                                 ///< column and row
  std::vector<std::atomic<bool>> is_marked_;  ///< whether a tile is in view
};

}  // namespace foveola
