#include "renderer/film/equirect_film.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr int largest_side = 65536;

/// Tiles that one task adds to.
constexpr std::size_t tile_block = 4;

std::uint32_t tiles_along(int side) {
  return static_cast<std::uint32_t>((side + EquirectFilm::tile_size - 1) / EquirectFilm::tile_size);
}

std::uint32_t pixel_coordinate(float position, int size) {
  return static_cast<std::uint32_t>(
      std::clamp(static_cast<int>(position * static_cast<float>(size)), 0, size - 1));
}

}  // namespace

EquirectFilm::EquirectFilm(int width, int height) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    throw Error("film size", fmt::format("{}x{} pixels cannot be made", width, height),
                fmt::format("choose sides from 1 to {}", largest_side));
  }
  tiles_across_ = tiles_along(width);
  tiles_.resize(static_cast<std::size_t>(tiles_across_) * tiles_along(height));
}

EquirectFilm::Place EquirectFilm::place(std::uint32_t x, std::uint32_t y) const {
  constexpr std::uint32_t size = tile_size;
  return {.tile = y / size * tiles_across_ + x / size, .index = y % size * size + x % size};
}

EquirectFilm::Place EquirectFilm::place(std::uint32_t pixel) const {
  const auto width = static_cast<std::uint32_t>(width_);
  return place(pixel % width, pixel / width);
}

void EquirectFilm::number(std::span<const ViewSample> samples, NumberedBatch& batch) {
  const std::vector<std::size_t> begins = sort_by_tile(samples, batch);
  batch.tiles.clear();
  for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) {
    if (begins[tile] < begins[tile + 1]) {
      batch.tiles.push_back({.tile = tile, .begin = begins[tile], .end = begins[tile + 1]});
      number_tile(batch.tiles.back(), batch);
    }
  }
}

std::vector<std::size_t> EquirectFilm::sort_by_tile(std::span<const ViewSample> samples,
                                                    NumberedBatch& batch) const {
  std::vector<std::uint32_t> pixels(samples.size());
  std::vector<std::size_t> begins(tiles_.size() + 1, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t x = pixel_coordinate(samples[i].image.x, width_);
    const std::uint32_t y = pixel_coordinate(samples[i].image.y, height_);
    pixels[i] = y * static_cast<std::uint32_t>(width_) + x;
    ++begins[place(x, y).tile + 1];
  }
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
    begins[tile + 1] += begins[tile];
  }
  batch.jobs.resize(samples.size());
  std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    batch.jobs[next[place(pixels[i]).tile]++] = {.direction = samples[i].direction,
                                                 .pixel = pixels[i]};
  }
  return begins;
}

void EquirectFilm::number_tile(const NumberedBatch::TileRange& range, NumberedBatch& batch) {
  std::unique_ptr<Tile>& tile = tiles_[range.tile];
  if (!tile) {
    tile = std::make_unique<Tile>();
  }
  for (std::size_t i = range.begin; i < range.end; ++i) {
    SampleJob& job = batch.jobs[i];
    job.sample_number = tile->numbered[place(job.pixel).index]++;
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
  Tile& tile = *tiles_[range.tile];
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (is_finite(radiance[i])) {
      const std::uint32_t index = place(batch.jobs[i].pixel).index;
      tile.sum[index] += DVec3(radiance[i]);
      ++tile.count[index];
    }
  }
}

void EquirectFilm::clear() {
  for (std::unique_ptr<Tile>& tile : tiles_) {
    tile.reset();
  }
  total_samples_ = 0;
}

FilmPixel EquirectFilm::pixel(int x, int y) const {
  assert(x >= 0 && x < width_ && y >= 0 && y < height_);
  const Place at = place(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  const Tile* tile = tiles_[at.tile].get();
  const std::uint32_t samples = tile != nullptr ? tile->count[at.index] : 0;
  if (samples == 0) {
    return {};
  }
  return {.mean = Rgb(tile->sum[at.index] / static_cast<double>(samples)), .samples = samples};
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
