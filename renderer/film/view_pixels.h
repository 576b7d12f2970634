// The places of a view's pixels on the equirect image, their levels, and their tiles.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/shown_color.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Sets each of `logs` to static_cast<float>(std::log2(number)), to the bit, for a library whose
/// log2 is exact within 1e-12. numbers: positive and normal, as many as logs.
void rounded_log2(std::span<const double> numbers, std::span<float> logs);

/// The numbers of eight pixels of a view, row by row.
using EightPixels = std::array<std::uint32_t, lane_count>;

/// Data of a view of width x height pixels: positions, which depend on the head, and levels, which
/// depend only on the lens and the fields of view. Different rows may be computed concurrently.
class ViewPixels {
 public:
  ViewPixels(int width, int height);
  std::uint32_t count() const { return static_cast<std::uint32_t>(width_) * height_; }

  /// Computes the positions in the rows [begin, end).
  void place(const Viewport& viewport, int begin, int end);
  /// Computes the levels, for a pyramid over an equirect image of `image_height` pixels: cells as
  /// high as a pixel of the view is wide. Towards the poles cells are narrower: a coarser level
  /// would blur vertically.
  void choose_levels(const Viewport& viewport, int image_height, int last_level, int begin,
                     int end);

  float highest_level() const;
  ViewPoints points(const EightPixels& pixels) const;
  /// The points of the eight pixels from `first`; those beyond the last pixel equal it, on some
  /// level.
  ViewPoints points_from(std::size_t first) const;

 private:
  Vec2 middle_of(int x, int y) const {
    return {(static_cast<float>(x) + 0.5F) / static_cast<float>(width_),
            (static_cast<float>(y) + 0.5F) / static_cast<float>(height_)};
  }
  std::size_t row(int y) const { return static_cast<std::size_t>(y) * width_; }

  int width_;
  int height_;
  std::vector<float> u_;
  std::vector<float> v_;
  std::vector<float> level_;
};

/// The fractional level whose cells are as high as a patch of `sr` steradians is wide, over an
/// equirect image of `image_height` pixels. At least 0.
float level_for(double sr, int image_height);

/// Marks the tiles of a view's pixels, and finds their surroundings.
class TilesInView {
 public:
  /// film must outlive this.
  explicit TilesInView(const EquirectFilm& film);

  void forget();
  /// Marks the tiles at eight positions on the image. Thread-safe.
  void mark(const Vec2s& image);

  /// Returns, ascending and without repetition, the tiles with a pixel less than a tile's side to
  /// the left, right, above or below of one in a marked tile. Includes those beyond the seam and
  /// the poles (there perhaps some more). They hold every cell that fewer than FilmTile::levels
  /// levels blend at a marked position, at most 24 pixels away.
  std::vector<std::uint32_t> around() const;

 private:
  const EquirectFilm* film_;
  Vec2 size_;                                 ///< the image's size in tiles
  Vec2 last_;                                 ///< column and row
  std::vector<std::atomic<bool>> is_marked_;  ///< whether a tile is in view
};

}  // namespace foveola
