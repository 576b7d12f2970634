#include "renderer/film/equirect_film.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr int largest_side = 65536;

/// Tiles that one task numbers or adds to.
constexpr std::size_t tile_block = 16;

int tiles_along(int side) { return (side + EquirectFilm::tile_size - 1) / EquirectFilm::tile_size; }

/// Throws Error unless a film may have this size.
int checked(int width, int height) {
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    throw Error("film size", fmt::format("{}x{} pixels cannot be made", width, height),
                fmt::format("choose sides from 1 to {}", largest_side));
  }
  return width;
}

int pixel_coordinate(float position, int size) {
  return std::clamp(static_cast<int>(position * static_cast<float>(size)), 0, size - 1);
}

double squared_luminance(const Rgb& radiance) {
  const double value = luminance(DVec3(radiance));
  return value * value;
}

std::vector<std::uint32_t> numbers_of(const std::vector<NumberedBatch::TileRange>& tiles) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(tiles.size());
  for (const NumberedBatch::TileRange& range : tiles) {
    numbers.push_back(range.tile);
  }
  return numbers;
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

IVec2 EquirectFilm::pixel_at(const Vec2& image) const {
  return {pixel_coordinate(image.x, width_), pixel_coordinate(image.y, height_)};
}

void EquirectFilm::number(std::span<const ViewSample> samples, NumberedBatch& batch,
                          const Workers& workers) {
  sort_by_tile(samples, batch);
  memory_->reserve(samples.size());
  for (const NumberedBatch::TileRange& range : batch.tiles) {
    if (tiles_[range.tile].epoch != epoch_) {
      living_tiles_.push_back(range.tile);
    }
  }
  for_each_tile(batch, workers,
                [&](const NumberedBatch::TileRange& range) { number_tile(range, batch); });
}

void EquirectFilm::sort_by_tile(std::span<const ViewSample> samples, NumberedBatch& batch) {
  sorting_.counts.resize(tiles_.size());
  sorting_.tiles.resize(samples.size());
  sorting_.pixels.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const IVec2 pixel = pixel_at(samples[i].image);
    sorting_.pixels[i] = pixel;
    sorting_.tiles[i] = tile_of(pixel.x, pixel.y);
    ++sorting_.counts[sorting_.tiles[i]];
  }
  batch.tiles.clear();
  std::uint32_t begin = 0;
  for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) {
    const std::uint32_t count = sorting_.counts[tile];
    if (count > 0) {
      batch.tiles.push_back({.tile = tile, .begin = begin, .end = begin + count});
      sorting_.counts[tile] = begin;
      begin += count;
    }
  }
  batch.jobs.resize(samples.size());
  batch.places.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const IVec2 pixel = sorting_.pixels[i];
    const std::uint32_t job = sorting_.counts[sorting_.tiles[i]]++;
    batch.jobs[job] = {
        .direction = samples[i].direction,
        .pixel = static_cast<std::uint32_t>(pixel.y) * static_cast<std::uint32_t>(width_) +
                 static_cast<std::uint32_t>(pixel.x)};
    batch.places[job] = place(pixel.x, pixel.y);
  }
  for (const NumberedBatch::TileRange& range : batch.tiles) {
    sorting_.counts[range.tile] = 0;
  }
}

template <typename Visit>
void EquirectFilm::visit_tile(const NumberedBatch& batch, std::size_t range,
                              const Visit& visit) const {
  // Of a crowded tile, whose pixels soon lie in the cache, the first jobs are enough.
  constexpr std::size_t most_jobs = 4;
  const NumberedBatch::TileRange& jobs = batch.tiles[range];
  const FilmTile* tile = find_tile(jobs.tile);
  if (tile != nullptr) {
    for (std::size_t job = jobs.begin; job < std::min(jobs.end, jobs.begin + most_jobs); ++job) {
      visit(*tile, batch.places[job]);
    }
  }
}

template <typename Work>
void EquirectFilm::for_each_tile(const NumberedBatch& batch, const Workers& workers,
                                 const Work& work) const {
  // Tiles that one takes to come from memory the next part of.
  constexpr std::size_t lead = 3;
  workers.for_each_block(batch.tiles.size(), tile_block, [&](std::size_t begin, std::size_t end) {
    const auto is_inside = [&](std::size_t range) { return range >= begin && range < end; };
    for (std::size_t step = begin; step < end + 3 * lead; ++step) {
      if (is_inside(step)) {
        visit_tile(batch, step, [](const FilmTile& tile, FilmTile::Place) { tile.prefetch(); });
      }
      if (is_inside(step - lead)) {
        visit_tile(batch, step - lead,
                   [](const FilmTile& tile, FilmTile::Place place) { tile.prefetch_block(place); });
      }
      if (is_inside(step - 2 * lead)) {
        visit_tile(batch, step - 2 * lead,
                   [](const FilmTile& tile, FilmTile::Place place) { tile.prefetch_pixel(place); });
      }
      if (is_inside(step - 3 * lead)) {
        work(batch.tiles[step - 3 * lead]);
      }
    }
  });
}

void EquirectFilm::number_tile(const NumberedBatch::TileRange& range, NumberedBatch& batch) {
  Slot& slot = tiles_[range.tile];
  if (slot.epoch != epoch_) {
    slot = {.tile = memory_->take_tile(), .epoch = epoch_};
  }
  for (std::size_t i = range.begin; i < range.end; ++i) {
    batch.jobs[i].sample_number = slot.tile->touch(batch.places[i], *memory_).numbered++;
  }
}

std::vector<DroppedSample> EquirectFilm::add(const NumberedBatch& batch,
                                             std::span<const Rgb> radiance,
                                             const Workers& workers) {
  assert(radiance.size() == batch.jobs.size());
  for_each_tile(batch, workers,
                [&](const NumberedBatch::TileRange& range) { add_tile(range, batch, radiance); });
  coarse_.refresh(numbers_of(batch.tiles));
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

void EquirectFilm::add_tile(const NumberedBatch::TileRange& range, const NumberedBatch& batch,
                            std::span<const Rgb> radiance) {
  FilmTile& tile = *tiles_[range.tile].tile;
  FilmTile::Touched touched;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (is_finite(radiance[i])) {
      const FilmTile::Place at = batch.places[i];
      FilmTile::Pixel& pixel = tile.at(at);
      pixel.sum += DVec3(radiance[i]);
      ++pixel.count;
      touched.add(at);
      if (with_squares_) {
        tile.squares(at) += squared_luminance(radiance[i]);
      }
    }
  }
  tile.refresh(touched);
  coarse_.finest(range.tile) = tile.cell(FilmTile::levels, 0, 0);
}

void EquirectFilm::clear() {
  ++epoch_;
  memory_->clear();
  coarse_.clear(living_tiles_);
  living_tiles_.clear();
  total_samples_ = 0;
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

Coverage EquirectFilm::cell(int level, int x, int y) const {
  if (level >= FilmTile::levels) {
    return coarse_.cell(level - FilmTile::levels, x, y);
  }
  const int tile_cells = tile_size >> level;
  const FilmTile* tile = find_tile(tile_of(x << level, y << level));
  return tile != nullptr ? tile->cell(level, x % tile_cells, y % tile_cells) : Coverage{};
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
