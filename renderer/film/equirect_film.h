// The 360-degree image in the making: it numbers samples, and averages the radiance they return.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/base/sample_job.h"
#include "renderer/image/image.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

/// A batch of view samples, sorted by tile and numbered: what the tracer is given.
struct NumberedBatch {
  /// The jobs of one tile, [begin, end) in `jobs`.
  struct TileRange {
    std::uint32_t tile = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  std::vector<SampleJob> jobs;
  std::vector<TileRange> tiles;
};

/// A sample that was dropped because its radiance was not finite; with the seed it reproduces the
/// path.
struct DroppedSample {
  std::uint32_t pixel = 0;
  std::uint32_t sample_number = 0;
};

/// One pixel of the film.
struct FilmPixel {
  Rgb mean{0.0F};             ///< black without samples
  std::uint32_t samples = 0;  ///< that the mean is of
};

/// A pixel is the mean of the samples that fell in it, kept as a sum in double and a count. Tiles
/// come to life when first sampled, so an untouched film of any size costs nothing.
class EquirectFilm {
 public:
  static constexpr int tile_size = 32;

  /// width and height in pixels, each in [1, 65536]. Throws Error otherwise.
  EquirectFilm(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Sorts samples by tile, stably, and gives each its pixel and that pixel's next sample number.
  void number(std::span<const ViewSample> samples, NumberedBatch& batch);

  /// Adds what the tracer returned for `batch`; radiance has as many elements as batch.jobs. One
  /// writer a tile. Non-finite radiance is left out and returned.
  std::vector<DroppedSample> add(const NumberedBatch& batch, std::span<const Rgb> radiance,
                                 const Workers& workers);

  /// Forgets everything; the next samples are numbered from 0.
  void clear();

  FilmPixel pixel(int x, int y) const;
  Rgb mean(int x, int y) const { return pixel(x, y).mean; }
  std::uint32_t sample_count(int x, int y) const { return pixel(x, y).samples; }
  std::uint64_t total_samples() const { return total_samples_; }

  /// The means and counts of the whole image.
  FilmImage resolve() const;

 private:
  /// Arrays apart, so that numbering moves a seventh of the memory that adding does.
  struct Tile {
    template <typename Value>
    using OfPixels = std::array<Value, static_cast<std::size_t>(tile_size) * tile_size>;
    OfPixels<DVec3> sum{};
    OfPixels<std::uint32_t> count{};     ///< samples in the sum
    OfPixels<std::uint32_t> numbered{};  ///< samples given a number
  };
  struct Place {
    std::uint32_t tile;
    std::uint32_t index;  ///< within the tile
  };

  Place place(std::uint32_t x, std::uint32_t y) const;
  Place place(std::uint32_t pixel) const;
  /// Fills batch.jobs, their numbers still missing; returns where each tile begins, and the end.
  std::vector<std::size_t> sort_by_tile(std::span<const ViewSample> samples,
                                        NumberedBatch& batch) const;
  void number_tile(const NumberedBatch::TileRange& range, NumberedBatch& batch);
  void add_tile(const NumberedBatch::TileRange& range, const NumberedBatch& batch,
                std::span<const Rgb> radiance);

  int width_;
  int height_;
  std::uint32_t tiles_across_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::uint64_t total_samples_ = 0;
};

}  // namespace foveola
