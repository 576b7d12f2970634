#include "renderer/film/sample_pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Number of points that one task draws.
constexpr std::size_t point_block = 4096;

/// Separates the random places within cells from the order of the cells.
constexpr std::uint32_t place_stream = 0x706c6163U;

/// Variation of the density within a pixel that is ignored. If radiance varies by a fifth from the
/// centre to the edge, the mean is then 0.1 % off: a third of both variations' product.
constexpr float negligible_variation = 0.015F;

/// Densities that differ more from the centre's jump within the pixel, and are not weighted.
constexpr float largest_weight = 2.0F;

/// Per unit of the image's area.
double image_density(const ViewSampler& sampler, const Vec3& direction) {
  return sampler.density_per_sr(direction) / equirect_area_per_sr(direction);
}

/// The density at a pixel's centre over that at a direction in it.
float weight_in_pixel(const ViewSampler& sampler, const EquirectFilm& film, const Vec3& direction,
                      const IVec2& pixel) {
  const Vec2 middle = (Vec2(pixel) + 0.5F) / Vec2(film.width(), film.height());
  const auto weight = static_cast<float>(image_density(sampler, direction_from_equirect(middle)) /
                                         image_density(sampler, direction));
  return weight > 1.0F / largest_weight && weight < largest_weight ? weight : 1.0F;
}

/// Whether any of a few samples has a density that deviates noticeably from its pixel's centre.
bool varies_within_pixels(const ViewSampler& sampler, const EquirectFilm& film) {
  std::array<Vec2, 128> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = sobol_2d(i, 0);
  }
  std::array<ViewSample, points.size()> samples;
  sampler.sample(points, samples);
  return std::ranges::any_of(samples, [&](const ViewSample& sample) {
    const float weight =
        weight_in_pixel(sampler, film, sample.direction, film.pixel_at(sample.image));
    return std::abs(weight - 1.0F) > negligible_variation;
  });
}

/// A cell in a round that visits each of `cells` once: the box of a Sobol point in the smallest
/// power-of-two grid that contains them. A box outside gives the rank of another point instead
/// (cycle walking: Black and Rogaway 2002, "Ciphers with Arbitrary Finite Domains").
IVec2 visited_cell(const IVec2& cells, std::uint64_t rank, std::uint32_t seed) {
  const IVec2 boxes(std::bit_ceil(static_cast<std::uint32_t>(cells.x)),
                    std::bit_ceil(static_cast<std::uint32_t>(cells.y)));
  while (true) {
    const IVec2 box(sobol_2d(rank, seed) * Vec2(boxes));
    if (box.x < cells.x && box.y < cells.y) {
      return box;
    }
    rank = static_cast<std::uint64_t>(
        box.y < cells.y ? std::int64_t{cells.x} * cells.y +
                              std::int64_t{boxes.x - cells.x} * box.y + box.x - cells.x
                        : std::int64_t{boxes.x} * box.y + box.x);
  }
}

/// The position in [0, 1) of a place in a cell, corrected if rounding leaves the cell.
float position_in(int cell, float place, int cells) {
  const auto size = static_cast<float>(cells);
  float position = (static_cast<float>(cell) + place) / size;
  while (static_cast<int>(position * size) > cell) {
    position = std::nextafter(position, 0.0F);
  }
  while (static_cast<int>(position * size) < cell) {
    position = std::nextafter(position, 1.0F);
  }
  return position;
}

/// Point `index` of the pattern that visits cells in rounds. Within a cell the points of all rounds
/// are a Sobol sequence.
Vec2 point_in_rounds(const IVec2& cells, std::uint64_t index, std::uint32_t seed) {
  const auto columns = static_cast<std::uint64_t>(cells.x);
  const std::uint64_t in_round = columns * static_cast<std::uint64_t>(cells.y);
  const std::uint64_t round = index / in_round;
  const IVec2 cell =
      visited_cell(cells, index % in_round, mix(seed, static_cast<std::uint32_t>(round)));
  const std::uint64_t number = static_cast<std::uint64_t>(cell.y) * columns + cell.x;
  const Vec2 place =
      sobol_2d(round, mix(mix(seed, place_stream), static_cast<std::uint32_t>(number)));
  return {position_in(cell.x, place.x, cells.x), position_in(cell.y, place.y, cells.y)};
}

/// Draws the points of `range` from `begin`.
void draw(const PointRange& range, std::size_t begin, std::span<Vec2> points) {
  const std::uint64_t first = range.first + begin;
  if (range.cells.x > 0) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = point_in_rounds(range.cells, first + i, range.seed);
    }
    return;
  }
  if (range.numbers == RandomNumbers::low_discrepancy) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = sobol_2d(first + i, range.seed);
    }
    return;
  }
  Pcg32 generator(range.seed, first);
  for (Vec2& point : points) {
    point.x = unit_float(generator.next());
    point.y = unit_float(generator.next());
  }
}

}  // namespace

std::vector<ViewSample>& SamplePass::draw_samples(const ViewSampler& sampler,
                                                  const PointRange& points,
                                                  const Workers& workers) {
  points_.resize(points.count);
  samples_.resize(points.count);
  workers.for_each_block(points.count, point_block, [&](std::size_t begin, std::size_t end) {
    const std::span<Vec2> drawn = std::span(points_).subspan(begin, end - begin);
    draw(points, begin, drawn);
    sampler.sample(drawn, std::span(samples_).subspan(begin, end - begin));
  });
  return samples_;
}

std::span<const SampleJob> SamplePass::number_samples(EquirectFilm& film, const Workers& workers) {
  film.number(samples_, batch_, workers);
  return batch_.jobs;
}

std::vector<DroppedSample> SamplePass::add_radiance(std::span<const Rgb> radiance,
                                                    const ViewSampler* weighs_by,
                                                    EquirectFilm& film, const Workers& workers) {
  weights_.clear();
  if (weighs_by != nullptr && !weighs_by->keeps_points() &&
      varies_within_pixels(*weighs_by, film)) {
    weights_.resize(batch_.jobs.size());
    workers.for_each_block(weights_.size(), point_block, [&](std::size_t begin, std::size_t end) {
      const auto width = static_cast<std::uint32_t>(film.width());
      for (std::size_t i = begin; i < end; ++i) {
        const SampleJob& job = batch_.jobs[i];
        weights_[i] = weight_in_pixel(*weighs_by, film, job.direction,
                                      IVec2(job.pixel % width, job.pixel / width));
      }
    });
  }
  return film.add(batch_, radiance, workers, weights_);
}

}  // namespace foveola
