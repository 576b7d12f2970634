// The 360-degree image during rendering: numbers samples, and averages their radiance.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/sample_job.h"
#include "renderer/base/work/parallel.h"
#include "renderer/film/film_tile.h"
#include "renderer/film/texel_pyramid.h"
#include "renderer/image/image.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// A batch of view samples, sorted by tile and numbered: the tracer's input.
struct NumberedBatch {
  /// The jobs of one tile, [begin, end) in `jobs`.
  struct TileRange {
    std::uint32_t tile = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  std::vector<SampleJob> jobs;
  std::vector<FilmTile::Place> places;  ///< each job's pixel in its tile
  std::vector<FilmTile::Slot> slots;    ///< each job's slot in its tile, until the film is cleared
  std::vector<TileRange> tiles;
};

/// A sample dropped for its non-finite radiance; with the seed it reproduces the path.
struct DroppedSample {
  std::uint32_t pixel = 0;
  std::uint32_t sample_number = 0;
};

/// One pixel of the film.
struct FilmPixel {
  Rgb mean{0.0F};             ///< black without samples
  std::uint32_t samples = 0;  ///< number of samples in the mean
};

/// The complete state of a pixel, bit for bit.
struct PixelState {
  std::uint32_t pixel = 0;     ///< y * width + x
  std::uint32_t count = 0;     ///< samples in the sums
  std::uint32_t numbered = 0;  ///< samples that were numbered
  DVec3 sum{0.0};              ///< of their radiance
  double squares = 0.0;        ///< of their squared luminance; 0 if the film keeps only means
};

/// Statistics per pixel: variances cost a third more memory and time.
enum class FilmStatistics { mean, mean_and_variance };

/// A pixel is the mean of its samples, stored as a sum in double (the mean times the count, if
/// samples have weights) and a count. Above the pixels stands a pyramid of averages, updated with
/// the samples. Memory is allocated at the first samples, so that an untouched film of any size
/// costs nothing, nor does clearing it.
class EquirectFilm {
 public:
  static constexpr int tile_size = FilmTile::size;
  static constexpr int largest_side = 65536;  ///< pixels

  /// width and height in pixels, each in [1, largest_side]. Throws Error otherwise.
  EquirectFilm(int width, int height, FilmStatistics statistics = FilmStatistics::mean);

  int width() const { return width_; }
  int height() const { return height_; }
  FilmStatistics statistics() const {
    return with_squares_ ? FilmStatistics::mean_and_variance : FilmStatistics::mean;
  }

  /// Sorts samples by tile, stably, and assigns each its pixel and that pixel's next sample number.
  void number(std::span<const ViewSample> samples, NumberedBatch& batch, const Workers& workers);

  /// Adds the traced radiance of `batch`, one element per job. One writer per tile. Returns the
  /// samples dropped for non-finite radiance. weights: one per job, positive; empty: all equal.
  /// Each moves its pixel's mean, of `count` samples before, by weight / (count + weight) of the
  /// way to the sample. The limit is the weighted mean, for weights of any scale, and exact if all
  /// samples are equal. Weights with a mean far below 1 converge slowly.
  std::vector<DroppedSample> add(const NumberedBatch& batch, std::span<const Rgb> radiance,
                                 const Workers& workers, std::span<const float> weights = {});

  /// Clears all pixels; samples are numbered from 0 again.
  void clear();

  /// Restores pixel states of another film of this size, each pixel once and only if it is empty
  /// here. Continues as that film would.
  void restore(std::span<const PixelState> states, const Workers& workers);

  /// The pixel that holds an image position.
  IVec2 pixel_at(const Vec2& image) const {
    return {coordinate_at(image.x, width_), coordinate_at(image.y, height_)};
  }
  FilmPixel pixel(int x, int y) const;
  Rgb mean(int x, int y) const { return pixel(x, y).mean; }
  std::uint32_t sample_count(int x, int y) const { return pixel(x, y).samples; }
  std::uint64_t total_samples() const { return total_samples_; }

  /// Unbiased variance of the luminance of a pixel's samples. nullopt with fewer than two samples,
  /// or if the film stores only means.
  std::optional<double> luminance_variance(int x, int y) const;

  /// The pyramid: a cell of level l has 2^l x 2^l pixels; level 0 are the pixels themselves, and
  /// the last level is a single cell. Cells that extend beyond the image are empty there: only
  /// sizes divisible by 2^l have levels without a seam.
  int levels() const { return FilmTile::levels + coarse_.count(); }
  int width(int level) const { return (width_ + (1 << level) - 1) >> level; }
  int height(int level) const { return (height_ + (1 << level) - 1) >> level; }
  PremultipliedTexel cell(int level, int x, int y) const;

  /// Revision for copies, which query tile by tile for changes since they were made. It grows with
  /// every added batch and every clear, from 0.
  FilmRevision revision() const { return revision_; }
  /// Revision of the last clear, 0 without one: older copies are void.
  FilmRevision cleared_at() const { return cleared_at_; }
  /// Tiles are numbered row by row; the last of a row or column may extend beyond the image.
  int tiles_across() const { return static_cast<int>(tiles_across_); }
  int tiles_down() const { return static_cast<int>(tiles_.size() / tiles_across_); }
  /// The tile that holds a pixel.
  std::uint32_t tile_of(int x, int y) const {
    return static_cast<std::uint32_t>(y / tile_size) * tiles_across_ +
           static_cast<std::uint32_t>(x / tile_size);
  }
  /// The pixel at a tile's top left corner.
  IVec2 tile_corner(std::uint32_t tile) const {
    return tile_size * IVec2(tile % tiles_across_, tile / tiles_across_);
  }
  /// Revision of the last samples added to a tile, or of the clear.
  FilmRevision tile_changed_at(std::uint32_t tile) const {
    const Slot& slot = tiles_[tile];
    return slot.epoch == epoch_ ? std::max(slot.changed_at, cleared_at_) : cleared_at_;
  }
  /// Calls visit(level, IVec2(x, y), texel) for a tile's non-empty cells, of the levels [0,
  /// FilmTile::levels), that changed after `since`; 0: all. On level 0 up to three unchanged
  /// neighbours of a changed pixel may be visited too. Cells of higher levels have pixels in many
  /// tiles: they must be copied whenever the film changed.
  template <typename Visit>
  void for_each_changed_cell(std::uint32_t tile, FilmRevision since, const Visit& visit) const;

  /// The state of a pixel; nullopt if no sample was numbered there.
  std::optional<PixelState> pixel_state(int x, int y) const;

  /// Calls visit(IVec2(x, y), pixel) for each pixel with samples, a const FilmTile::Pixel, row by
  /// row from the top left.
  template <typename Visit>
  void for_each_sampled_pixel(const Visit& visit) const;

  /// Means and counts of the whole image, and variances if stored.
  FilmImage resolve() const;

 private:
  /// An element of the tiles' array.
  struct Slot {
    FilmTile* tile = nullptr;
    std::uint32_t epoch = 0;  ///< the tile's epoch; tiles of other epochs are void
    FilmRevision changed_at = 0;
  };
  /// Buffers of sort_by_tile.
  struct Sorting {
    std::vector<std::uint32_t> places;   ///< place of each sample's tile in the order of tiles
    std::vector<std::uint32_t> counts;   ///< samples per tile, by place; 0 between calls
    std::vector<std::uint64_t> sampled;  ///< one bit per place; all 0 between calls
    std::vector<std::uint32_t> order;    ///< the samples' indices, by tile
  };

  static int coordinate_at(float position, int size) {
    return std::clamp(static_cast<int>(position * static_cast<float>(size)), 0, size - 1);
  }
  static FilmTile::Place place(int x, int y) { return {x % tile_size, y % tile_size}; }
  /// Null without samples since the film was cleared.
  const FilmTile* find_tile(std::uint32_t tile) const {
    const Slot& slot = tiles_[tile];
    return slot.epoch == epoch_ ? slot.tile : nullptr;
  }
  const FilmTile::Pixel* find_pixel(int x, int y) const {
    const FilmTile* tile = find_tile(tile_of(x, y));
    return tile != nullptr ? tile->find(place(x, y)) : nullptr;
  }
  using TileRanges = std::span<const NumberedBatch::TileRange>;

  /// Fills the batch's tiles, and sorting_.order.
  void sort_by_tile(std::span<const ViewSample> samples, NumberedBatch& batch);
  /// Fills sorting_ except order.
  void count_by_tile(std::span<const ViewSample> samples);
  /// Assigns contiguous ranges to the tiles with samples, and their beginnings to sorting_.counts.
  void find_ranges(std::vector<NumberedBatch::TileRange>& ranges);
  /// Batches order their tiles along squares, so that consecutive jobs are close in both
  /// directions. Converts a tile's column and row to its place in that order, and back.
  std::uint32_t place_in_order(const IVec2& tile) const;
  std::uint32_t tile_at(std::uint32_t place) const;
  /// Fills the batch's jobs and their data.
  void number_tiles(TileRanges ranges, std::span<const ViewSample> samples, NumberedBatch& batch);
  void bring_to_life(TileRanges ranges, NumberedBatch& batch);
  void add_tiles(TileRanges ranges, const NumberedBatch& batch, std::span<const Rgb> radiance,
                 std::span<const float> weights);
  void add_tile(const NumberedBatch::TileRange& range, const NumberedBatch& batch,
                std::span<const Rgb> radiance, std::span<const float> weights);

  int width_;
  int height_;
  bool with_squares_;
  std::uint32_t tiles_across_;
  std::unique_ptr<FilmTile::Memory> memory_;
  std::vector<Slot> tiles_;
  std::vector<std::uint32_t> living_tiles_;  ///< tiles of this epoch
  Sorting sorting_;
  TexelPyramid coarse_;  ///< levels from one cell per tile upwards
  /// Epoch of the samples since the last clear; grows with each clear.
  std::uint32_t epoch_ = 1;
  std::uint64_t total_samples_ = 0;
  FilmRevision revision_ = 0;
  FilmRevision cleared_at_ = 0;
};

template <typename Visit>
void EquirectFilm::for_each_changed_cell(std::uint32_t tile, FilmRevision since,
                                         const Visit& visit) const {
  if (const FilmTile* found = find_tile(tile)) {
    const IVec2 corner = tile_corner(tile);
    found->for_each_changed_cell(
        since, [&](int level, const IVec2& in_tile, const PremultipliedTexel& texel) {
          visit(level, IVec2(corner.x >> level, corner.y >> level) + in_tile, texel);
        });
  }
}

template <typename Visit>
void EquirectFilm::for_each_sampled_pixel(const Visit& visit) const {
  for (int y = 0; y < height_; ++y) {
    for (int left = 0; left < width_; left += tile_size) {
      const FilmTile* tile = find_tile(tile_of(left, y));
      const int end = tile != nullptr ? std::min(left + tile_size, width_) : left;
      for (int x = left; x < end; ++x) {
        const FilmTile::Pixel* pixel = tile->find(place(x, y));
        if (pixel != nullptr && pixel->count > 0) {
          visit(IVec2(x, y), *pixel);
        }
      }
    }
  }
}

}  // namespace foveola
