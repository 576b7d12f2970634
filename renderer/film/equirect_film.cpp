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
      tiles_(static_cast<std::size_t>(tiles_along(width)) * tiles_along(height)),
      coarse_(tiles_along(width), tiles_along(height)) {}

IVec2 EquirectFilm::pixel_at(const Vec2& image) const {
  return {pixel_coordinate(image.x, width_), pixel_coordinate(image.y, height_)};
}

EquirectFilm::Place EquirectFilm::place(int x, int y) const {
  return {.tile = static_cast<std::uint32_t>(y / tile_size) * tiles_across_ +
                  static_cast<std::uint32_t>(x / tile_size),
          .x = x % tile_size,
          .y = y % tile_size};
}

EquirectFilm::Place EquirectFilm::place(std::uint32_t pixel) const {
  const auto width = static_cast<std::uint32_t>(width_);
  return place(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
}

const FilmTile* EquirectFilm::find_tile(std::uint32_t tile) const {
  const FilmTile* found = tiles_[tile].get();
  return found != nullptr && found->epoch() == epoch_ ? found : nullptr;
}

void EquirectFilm::number(std::span<const ViewSample> samples, NumberedBatch& batch,
                          const Workers& workers) {
  sort_by_tile(samples, batch);
  workers.for_each_block(batch.tiles.size(), tile_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      number_tile(batch.tiles[i], batch);
    }
  });
}

void EquirectFilm::sort_by_tile(std::span<const ViewSample> samples, NumberedBatch& batch) const {
  std::vector<std::uint32_t> pixels(samples.size());
  std::vector<std::uint32_t> tiles(samples.size());
  std::vector<std::size_t> begins(tiles_.size() + 1, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const IVec2 pixel = pixel_at(samples[i].image);
    pixels[i] = static_cast<std::uint32_t>(pixel.y) * static_cast<std::uint32_t>(width_) +
                static_cast<std::uint32_t>(pixel.x);
    tiles[i] = place(pixel.x, pixel.y).tile;
    ++begins[tiles[i] + 1];
  }
  batch.tiles.clear();
  for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) {
    const std::size_t count = begins[tile + 1];
    begins[tile + 1] += begins[tile];
    if (count > 0) {
      batch.tiles.push_back({.tile = tile, .begin = begins[tile], .end = begins[tile + 1]});
    }
  }
  batch.jobs.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    batch.jobs[begins[tiles[i]]++] = {.direction = samples[i].direction, .pixel = pixels[i]};
  }
}

void EquirectFilm::number_tile(const NumberedBatch::TileRange& range, NumberedBatch& batch) {
  std::unique_ptr<FilmTile>& tile = tiles_[range.tile];
  if (!tile) {
    tile = std::make_unique<FilmTile>();
  }
  tile->enter(epoch_);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Place at = place(batch.jobs[i].pixel);
    batch.jobs[i].sample_number = tile->touch(at.x, at.y, with_squares_).numbered++;
  }
}

std::vector<DroppedSample> EquirectFilm::add(const NumberedBatch& batch,
                                             std::span<const Rgb> radiance,
                                             const Workers& workers) {
  assert(radiance.size() == batch.jobs.size());
  workers.for_each_block(batch.tiles.size(), tile_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      add_tile(batch.tiles[i], batch, radiance);
    }
  });
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
  FilmTile& tile = *tiles_[range.tile];
  FilmTile::Touched touched;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (is_finite(radiance[i])) {
      const Place at = place(batch.jobs[i].pixel);
      FilmTile::Pixel& pixel = tile.at(at.x, at.y);
      pixel.sum += DVec3(radiance[i]);
      ++pixel.count;
      touched.add(at.x, at.y);
      if (with_squares_) {
        tile.squares(at.x, at.y) += squared_luminance(radiance[i]);
      }
    }
  }
  tile.refresh(touched);
  coarse_.finest(range.tile) = tile.cell(FilmTile::levels, 0, 0);
}

void EquirectFilm::clear() {
  ++epoch_;
  coarse_.clear();
  total_samples_ = 0;
}

FilmPixel EquirectFilm::pixel(int x, int y) const {
  assert(x >= 0 && x < width_ && y >= 0 && y < height_);
  const Place at = place(x, y);
  const FilmTile* tile = find_tile(at.tile);
  const FilmTile::Pixel* pixel = tile != nullptr ? tile->find(at.x, at.y) : nullptr;
  return pixel != nullptr ? FilmPixel{.mean = pixel->mean(), .samples = pixel->count} : FilmPixel{};
}

std::optional<double> EquirectFilm::luminance_variance(int x, int y) const {
  const Place at = place(x, y);
  const FilmTile* tile = find_tile(at.tile);
  const FilmTile::Pixel* pixel = tile != nullptr ? tile->find(at.x, at.y) : nullptr;
  if (!with_squares_ || pixel == nullptr || pixel->count < 2) {
    return std::nullopt;
  }
  const double n = pixel->count;
  const double mean = luminance(pixel->sum) / n;
  return std::max(0.0, (tile->squares(at.x, at.y) / n - mean * mean) * n / (n - 1.0));
}

Coverage EquirectFilm::cell(int level, int x, int y) const {
  if (level >= FilmTile::levels) {
    return coarse_.cell(level - FilmTile::levels, x, y);
  }
  const Place at = place(x << level, y << level);
  const FilmTile* tile = find_tile(at.tile);
  return tile != nullptr ? tile->cell(level, at.x >> level, at.y >> level) : Coverage{};
}

FilmImage EquirectFilm::resolve() const {
  FilmImage image{.color = RgbImage(width_, height_), .samples = {}};
  image.samples.reserve(image.color.pixels.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const FilmPixel resolved = pixel(x, y);
      image.color.at(x, y) = resolved.mean;
      image.samples.push_back(resolved.samples);
    }
  }
  return image;
}

}  // namespace foveola
