// Maps points of the unit square to samples, block by block: the loop that samplers share.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "renderer/base/angles.h"
#include "renderer/view/equirect.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

inline constexpr std::size_t sample_block_size = 256;

/// Writes the samples in the directions of at most `sample_block_size` points. Compilers vectorise
/// it if `direction_of` has no branch.
template <typename DirectionOf>
void sample_block(std::span<const Vec2> points, const DirectionOf& direction_of,
                  std::span<ViewSample> samples) {
  std::array<float, sample_block_size> x;
  std::array<float, sample_block_size> y;
  std::array<float, sample_block_size> z;
  std::array<float, sample_block_size> u;
  std::array<float, sample_block_size> v;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 direction = direction_of(points[i]);
    const Vec2 image = equirect_from_direction(direction);
    x[i] = direction.x;
    y[i] = direction.y;
    z[i] = direction.z;
    u[i] = image.x;
    v[i] = image.y;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    samples[i] = {.direction = {x[i], y[i], z[i]}, .image = {u[i], v[i]}};
  }
}

/// Writes the samples at places in the equirect image, for any number of points: `place` maps each.
template <typename Place>
void sample_places(std::span<const Vec2> points, const Place& place,
                   std::span<ViewSample> samples) {
  std::array<Vec2, sample_block_size> images;
  std::array<Vec3, sample_block_size> directions;
  for (std::size_t begin = 0; begin < points.size(); begin += sample_block_size) {
    const std::size_t count = std::min(sample_block_size, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      images[i] = place(points[begin + i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      directions[i] = direction_from_equirect(images[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      samples[begin + i] = {.direction = directions[i], .image = images[i]};
    }
  }
}

/// Writes the samples in the directions of any number of points. `prepare` maps a block of points,
/// with branches and look-ups, to the inputs of `direction_of`.
template <typename Prepare, typename DirectionOf>
void sample_blocks(std::span<const Vec2> points, const Prepare& prepare,
                   const DirectionOf& direction_of, std::span<ViewSample> samples) {
  std::array<Vec2, sample_block_size> prepared;
  for (std::size_t begin = 0; begin < points.size(); begin += sample_block_size) {
    const std::size_t count = std::min(sample_block_size, points.size() - begin);
    const std::span<Vec2> block = std::span(prepared).first(count);
    prepare(points.subspan(begin, count), block);
    sample_block(block, direction_of, samples.subspan(begin, count));
  }
}

/// Turns a `map` from point to point into a `prepare` of sample_blocks.
template <typename Map>
auto point_by_point(Map map) {
  return [map](std::span<const Vec2> points, std::span<Vec2> prepared) {
    std::transform(points.begin(), points.end(), prepared.begin(), map);
  };
}

/// sample_blocks around `frame.normal`: `polar` maps a block of points to their eccentricities and
/// azimuths, both in turns.
template <typename Polar>
void sample_around(const Frame& frame, std::span<const Vec2> points, const Polar& polar,
                   std::span<ViewSample> samples) {
  const auto direction_of = [frame](const Vec2& turns) {
    const auto [radius, ahead] = sine_cosine_of_turns(turns.x);
    const auto [sine, cosine] = sine_cosine_of_turns(turns.y);
    return frame.to_world({radius * cosine, radius * sine, ahead});
  };
  sample_blocks(points, polar, direction_of, samples);
}

}  // namespace foveola
