#include "renderer/film/equirect_film.h"

#include <bit>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"

namespace foveola {
namespace {

/// Number of tiles that one task numbers or adds to.
constexpr std::size_t tile_block = 64;

/// Distance of prefetching, in samples.
constexpr std::size_t samples_ahead = 16;
constexpr std::size_t tiles_ahead = 6;

/// Tiles along a side of a square, one bit of a word each.
constexpr int square_side = 8;
constexpr std::size_t word_bits = square_side * square_side;

int squares_along(int tiles) { return (tiles + square_side - 1) / square_side; }

int tiles_along(int side) { return (side + EquirectFilm::tile_size - 1) / EquirectFilm::tile_size; }

/// Throws Error unless a film may have this size.
int checked(int width, int height) {
  if (width < 1 || height < 1 || width > EquirectFilm::largest_side ||
      height > EquirectFilm::largest_side) {
    throw Error("film size", fmt::format("{}x{} pixels cannot be made", width, height),
                fmt::format("choose sides from 1 to {}", EquirectFilm::largest_side));
  }
  return width;
}

double squared_luminance(const Rgb& radiance) {
  const double value = luminance(DVec3(radiance));
  return value * value;
}

/// As in EquirectFilm::add(); sum: `count` times the mean.
template <typename Value>
void add_weighed(double weight, std::uint32_t count, Value& sum, const Value& value) {
  sum += weight * value;
  if (weight != 1.0) {
    sum *= (count + 1.0) / (count + weight);
  }
}

std::vector<std::uint32_t> tile_indices(const std::vector<NumberedBatch::TileRange>& tiles) {
  return transformed(tiles, &NumberedBatch::TileRange::tile);
}

}  // namespace

EquirectFilm::EquirectFilm(int width, int height, FilmStatistics statistics)
    : width_(checked(width, height)),
      height_(height),
      with_squares_(statistics == FilmStatistics::mean_and_variance),
      tiles_across_(static_cast<std::uint32_t>(tiles_along(width))),
      memory_(std::make_unique<FilmTile::Memory>(with_squares_)),
      tiles_(static_cast<std::size_t>(tiles_along(width)) * tiles_along(height)),
      coarse_(tiles_along(width), tiles_along(height)) {}

void EquirectFilm::number(std::span<const ViewSample> samples, NumberedBatch& batch,
                          const Workers& workers) {
  sort_by_tile(samples, batch);
  batch.jobs.resize(samples.size());
  batch.places.resize(samples.size());
  batch.slots.resize(samples.size());
  for (const NumberedBatch::TileRange& range : batch.tiles) {
    if (tiles_[range.tile].epoch != epoch_) {
      living_tiles_.push_back(range.tile);
    }
  }
  workers.for_each_block(batch.tiles.size(), tile_block, [&](std::size_t begin, std::size_t end) {
    number_tiles(TileRanges(batch.tiles).subspan(begin, end - begin), samples, batch);
  });
  // While the batch is traced.
  memory_->make_ready();
}

void EquirectFilm::sort_by_tile(std::span<const ViewSample> samples, NumberedBatch& batch) {
  count_by_tile(samples);
  find_ranges(batch.tiles);
  sorting_.order.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sorting_.order[sorting_.counts[sorting_.places[i]]++] = static_cast<std::uint32_t>(i);
  }
  for (const std::uint32_t place : sorting_.places) {
    sorting_.counts[place] = 0;
  }
}

void EquirectFilm::count_by_tile(std::span<const ViewSample> samples) {
  const auto squares = static_cast<std::size_t>(squares_along(tiles_across())) *
                       static_cast<std::size_t>(squares_along(tiles_down()));
  sorting_.counts.resize(squares * word_bits);
  sorting_.sampled.resize(squares);
  sorting_.places.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t place = place_in_order(pixel_at(samples[i].image) / tile_size);
    sorting_.places[i] = place;
    ++sorting_.counts[place];
    sorting_.sampled[place / word_bits] |= std::uint64_t{1} << place % word_bits;
  }
}

void EquirectFilm::find_ranges(std::vector<NumberedBatch::TileRange>& ranges) {
  ranges.clear();
  std::uint32_t begin = 0;
  for (std::size_t word = 0; word < sorting_.sampled.size(); ++word) {
    for (std::uint64_t left = std::exchange(sorting_.sampled[word], 0); left != 0;
         left &= left - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(left));
      const auto place = static_cast<std::uint32_t>(word * word_bits + bit);
      const std::uint32_t end = begin + std::exchange(sorting_.counts[place], begin);
      ranges.push_back({.tile = tile_at(place), .begin = begin, .end = end});
      begin = end;
    }
  }
}

std::uint32_t EquirectFilm::place_in_order(const IVec2& tile) const {
  const IVec2 square = tile / square_side;
  const IVec2 inside = tile % square_side;
  const int number = square.y * squares_along(tiles_across()) + square.x;
  return static_cast<std::uint32_t>((number * square_side + inside.y) * square_side + inside.x);
}

std::uint32_t EquirectFilm::tile_at(std::uint32_t place) const {
  const auto inside = static_cast<int>(place % word_bits);
  const auto number = static_cast<int>(place / word_bits);
  const int squares_across = squares_along(tiles_across());
  const int x = number % squares_across * square_side + inside % square_side;
  const int y = number / squares_across * square_side + inside / square_side;
  return static_cast<std::uint32_t>(y) * tiles_across_ + static_cast<std::uint32_t>(x);
}

void EquirectFilm::number_tiles(TileRanges ranges, std::span<const ViewSample> samples,
                                NumberedBatch& batch) {
  const std::size_t end = ranges.back().end;
  for (std::size_t i = ranges.front().begin; i < end; ++i) {
    __builtin_prefetch(&samples[sorting_.order[std::min(i + samples_ahead, end - 1)]]);
    const ViewSample& sample = samples[sorting_.order[i]];
    const IVec2 pixel = pixel_at(sample.image);
    batch.jobs[i] = {
        .direction = sample.direction,
        .pixel = static_cast<std::uint32_t>(pixel.y) * static_cast<std::uint32_t>(width_) +
                 static_cast<std::uint32_t>(pixel.x)};
    batch.places[i] = place(pixel.x, pixel.y);
  }
  bring_to_life(ranges, batch);
  for (std::size_t i = ranges.front().begin; i < end; ++i) {
    batch.jobs[i].sample_number = batch.slots[i].pixel(batch.places[i]).numbered++;
  }
}

// Each step runs for all samples before the next, so that its prefetches overlap.
void EquirectFilm::bring_to_life(TileRanges ranges, NumberedBatch& batch) {
  FilmTile::Taker memory(*memory_);
  for (const NumberedBatch::TileRange& range : ranges) {
    Slot& slot = tiles_[range.tile];
    if (slot.epoch != epoch_) {
      slot = {.tile = memory.take_tile(), .epoch = epoch_};
    }
    slot.tile->prefetch_block(batch.places[range.begin]);
  }
  for (const NumberedBatch::TileRange& range : ranges) {
    FilmTile& tile = *tiles_[range.tile].tile;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      tile.touch_block(batch.places[i], memory, batch.slots[i]);
    }
  }
  for (std::size_t i = ranges.front().begin; i < ranges.back().end; ++i) {
    FilmTile::touch_quad(batch.places[i], memory, batch.slots[i]);
  }
}

std::vector<DroppedSample> EquirectFilm::add(const NumberedBatch& batch,
                                             std::span<const Rgb> radiance, const Workers& workers,
                                             std::span<const float> weights) {
  assert(radiance.size() == batch.jobs.size());
  assert(weights.empty() || weights.size() == radiance.size());
  ++revision_;
  workers.for_each_block(batch.tiles.size(), tile_block, [&](std::size_t begin, std::size_t end) {
    add_tiles(TileRanges(batch.tiles).subspan(begin, end - begin), batch, radiance, weights);
  });
  coarse_.refresh(tile_indices(batch.tiles));  // the pyramid above the tiles
  std::vector<DroppedSample> dropped;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (!is_finite(radiance[i])) {
      dropped.push_back(
          {.pixel = batch.jobs[i].pixel, .sample_number = batch.jobs[i].sample_number});
    }
  }
  total_samples_ += radiance.size() - dropped.size();
  return dropped;
}

void EquirectFilm::add_tiles(TileRanges ranges, const NumberedBatch& batch,
                             std::span<const Rgb> radiance, std::span<const float> weights) {
  const std::size_t end = ranges.back().end;
  std::size_t asked_jobs = ranges.front().begin;
  std::size_t asked_tiles = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    for (; asked_jobs < std::min(ranges[i].end + samples_ahead, end); ++asked_jobs) {
      batch.slots[asked_jobs].prefetch(batch.places[asked_jobs]);
    }
    for (; asked_tiles < std::min(i + tiles_ahead, ranges.size()); ++asked_tiles) {
      const NumberedBatch::TileRange& range = ranges[asked_tiles];
      tiles_[range.tile].tile->prefetch_means(batch.places[range.begin]);
    }
    add_tile(ranges[i], batch, radiance, weights);
  }
}

void EquirectFilm::add_tile(const NumberedBatch::TileRange& range, const NumberedBatch& batch,
                            std::span<const Rgb> radiance, std::span<const float> weights) {
  FilmTile& tile = *tiles_[range.tile].tile;
  FilmTile::Touched touched;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (is_finite(radiance[i])) {
      const FilmTile::Place at = batch.places[i];
      FilmTile::Pixel& pixel = batch.slots[i].pixel(at);
      const double weight = weights.empty() ? 1.0 : weights[i];
      add_weighed(weight, pixel.count, pixel.sum, DVec3(radiance[i]));
      if (with_squares_) {
        add_weighed(weight, pixel.count, batch.slots[i].squares(at),
                    squared_luminance(radiance[i]));
      }
      ++pixel.count;
      touched.add(at);
    }
  }
  coarse_.finest(range.tile) = tile.refresh(touched, revision_);
  tiles_[range.tile].changed_at = revision_;
}

void EquirectFilm::clear() {
  ++epoch_;
  cleared_at_ = ++revision_;
  memory_->clear();
  coarse_.clear(living_tiles_);
  living_tiles_.clear();
  total_samples_ = 0;
}

void EquirectFilm::restore(std::span<const PixelState> states, const Workers& workers) {
  const auto width = static_cast<std::uint32_t>(width_);
  std::vector<ViewSample> samples(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Vec2 place(states[i].pixel % width, states[i].pixel / width);
    samples[i].image = (place + 0.5F) / Vec2(width_, height_);
  }
  NumberedBatch batch;
  number(samples, batch, workers);
  ++revision_;
  for (const NumberedBatch::TileRange& range : batch.tiles) {
    FilmTile::Touched touched;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const PixelState& state = states[sorting_.order[i]];
      const FilmTile::Place at = batch.places[i];
      batch.slots[i].pixel(at) = {
          .sum = state.sum, .count = state.count, .numbered = state.numbered};
      if (with_squares_) {
        batch.slots[i].squares(at) = state.squares;
      }
      if (state.count > 0) {
        touched.add(at);
      }
      total_samples_ += state.count;
    }
    coarse_.finest(range.tile) = tiles_[range.tile].tile->refresh(touched, revision_);
    tiles_[range.tile].changed_at = revision_;
  }
  coarse_.refresh(tile_indices(batch.tiles));  // the pyramid above the tiles
}

std::optional<PixelState> EquirectFilm::pixel_state(int x, int y) const {
  const FilmTile::Pixel* const found = find_pixel(x, y);
  if (found == nullptr || found->numbered == 0) {
    return std::nullopt;
  }
  return PixelState{
      .pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width_) +
               static_cast<std::uint32_t>(x),
      .count = found->count,
      .numbered = found->numbered,
      .sum = found->sum,
      .squares = with_squares_ ? find_tile(tile_of(x, y))->squares(place(x, y)) : 0.0};
}

FilmPixel EquirectFilm::pixel(int x, int y) const {
  assert(x >= 0 && x < width_ && y >= 0 && y < height_);
  const FilmTile::Pixel* pixel = find_pixel(x, y);
  return pixel != nullptr ? FilmPixel{.mean = pixel->mean(), .samples = pixel->count} : FilmPixel{};
}

std::optional<double> EquirectFilm::luminance_variance(int x, int y) const {
  const FilmTile::Pixel* pixel = find_pixel(x, y);
  if (!with_squares_ || pixel == nullptr || pixel->count < 2) {
    return std::nullopt;
  }
  const double n = pixel->count;
  const double mean = luminance(pixel->sum) / n;
  const double squares = find_tile(tile_of(x, y))->squares(place(x, y));
  return std::max(0.0, (squares / n - mean * mean) * n / (n - 1.0));
}

PremultipliedTexel EquirectFilm::cell(int level, int x, int y) const {
  if (level >= FilmTile::levels) {
    return coarse_.cell(level - FilmTile::levels, x, y);
  }
  const int tile_cells = tile_size >> level;
  const FilmTile* tile = find_tile(tile_of(x << level, y << level));
  return tile != nullptr ? tile->cell(level, x % tile_cells, y % tile_cells) : PremultipliedTexel{};
}

FilmImage EquirectFilm::resolve() const {
  FilmImage image{.color = RgbImage(width_, height_), .samples = {}, .variances = {}};
  image.samples.reserve(image.color.pixels.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const FilmPixel resolved = pixel(x, y);
      image.color.at(x, y) = resolved.mean;
      image.samples.push_back(resolved.samples);
      if (with_squares_) {
        image.variances.push_back(static_cast<float>(luminance_variance(x, y).value_or(0.0)));
      }
    }
  }
  return image;
}

}  // namespace foveola
