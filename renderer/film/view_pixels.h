// Where the pixels of a view lie on the equirect image, how large they are on it, and which tiles
// of a film they are made from.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/shown_color.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Sets each of `logs` to static_cast<float>(std::log2(number)), to the bit, for a library whose
/// log2 is right within 1e-12. numbers: positive and normal, as many as logs.
void rounded_log2(std::span<const double> numbers, std::span<float> logs);

/// The numbers of eight pixels of a view, row by row.
using EightPixels = std::array<std::uint32_t, lane_count>;

/// What is known of a view of width x height pixels: positions, which turn with the head, and
/// levels, which depend on the lens and the fields of view alone. Different rows may be worked out
/// at the same time.
class ViewPixels {
 public:
  ViewPixels(int width, int height);
  std::uint32_t count() const { return static_cast<std::uint32_t>(width_) * height_; }

  /// Works out the positions in the rows [begin, end).
  void place(const Viewport& viewport, int begin, int end);
  /// Works out the levels, for a pyramid over an equirect image of `image_height` pixels: those
  /// whose cells are as high as a pixel of the view is wide. Towards the poles cells become
  /// narrower than that: taking a coarser level would blur upwards and downwards.
  void choose_levels(const Viewport& viewport, int image_height, int last_level, int begin,
                     int end);

  float highest_level() const;
  ViewPoints points(const EightPixels& pixels) const;
  /// The points of the eight pixels from `first` on; beyond the last pixel they lie where that
  /// does, on some level.
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

/// The level, in between two of them perhaps, whose cells are as high as a patch of `sr` steradians
/// is wide, over an equirect image of `image_height` pixels. At least 0.
float level_for(double sr, int image_height);

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
