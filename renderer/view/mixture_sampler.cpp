#include "renderer/view/mixture_sampler.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "renderer/base/unit_interval.h"

namespace foveola {
MixtureSampler::MixtureSampler(std::vector<Part> parts) : parts_(std::move(parts)) {
  // Relative to the largest first: the sum of weights may be more than a double holds.
  const auto heavier = [](const Part& a, const Part& b) { return a.weight < b.weight; };
  const double largest = std::max_element(parts_.begin(), parts_.end(), heavier)->weight;
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
  std::vector<std::size_t> places;
  std::vector<Vec2> part_points;
  std::vector<ViewSample> part_samples;
  float begin = 0.0F;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    places.clear();
    part_points.clear();
    const auto weight = static_cast<float>(parts_[part].weight);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].x >= begin && points[i].x < ends_[part]) {
        places.push_back(i);
        part_points.emplace_back(std::min((points[i].x - begin) / weight, largest_below_one),
                                 points[i].y);
      }
    }
    part_samples.resize(part_points.size());
    parts_[part].sampler->sample(part_points, part_samples);
    for (std::size_t i = 0; i < places.size(); ++i) {
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
