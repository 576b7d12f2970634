#include "renderer/view/mixture_sampler.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

/// Points per call of a part: their data stay in the nearest cache.
constexpr std::size_t block_size = 512;

}  // namespace

MixtureSampler::MixtureSampler(std::vector<Part> parts) : parts_(std::move(parts)) {
  // Relative to the maximum first: the sum of weights may exceed a double.
  const auto heavier = [](const Part& a, const Part& b) { return a.weight < b.weight; };
  const double largest = std::ranges::max_element(parts_, heavier)->weight;
  double total = 0.0;
  for (Part& part : parts_) {
    part.weight /= largest;
    total += part.weight;
  }
  double end = 0.0;
  for (Part& part : parts_) {
    part.weight /= total;
    end += part.weight;
    ends_.push_back(static_cast<float>(end));
  }
  ends_.back() = std::numeric_limits<float>::infinity();
}

void MixtureSampler::aim(const Aim& aim) {
  for (const Part& part : parts_) {
    part.sampler->aim(aim);
  }
}

void MixtureSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  for (std::size_t begin = 0; begin < points.size(); begin += block_size) {
    const std::size_t count = std::min(block_size, points.size() - begin);
    sample_block(points.subspan(begin, count), samples.subspan(begin, count));
  }
}

void MixtureSampler::sample_block(std::span<const Vec2> points,
                                  std::span<ViewSample> samples) const {
  std::array<std::size_t, block_size> places;
  std::array<Vec2, block_size> part_points;
  std::array<ViewSample, block_size> part_samples;
  float begin = 0.0F;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const auto weight = static_cast<float>(parts_[part].weight);
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Points of other parts are overwritten: a branch would be mispredicted at random.
      places[count] = i;
      part_points[count] =
          Vec2(std::min((points[i].x - begin) / weight, largest_below_one), points[i].y);
      count += points[i].x >= begin && points[i].x < ends_[part] ? 1 : 0;
    }
    parts_[part].sampler->sample(std::span(part_points).first(count),
                                 std::span(part_samples).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      samples[places[i]] = part_samples[i];
    }
    begin = ends_[part];
  }
}

double MixtureSampler::density_per_sr(const Vec3& direction) const {
  double density = 0.0;
  for (const Part& part : parts_) {
    density += part.weight * part.sampler->density_per_sr(direction);
  }
  return density;
}

}  // namespace foveola
