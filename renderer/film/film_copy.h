// A copy of what a film's pyramid knows where it is looked at, laid out for reading.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/sphere_planes.h"
#include "renderer/film/square_changes.h"

namespace foveola {

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
