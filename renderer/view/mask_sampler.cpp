#include "renderer/view/mask_sampler.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <system_error>
#include <utility>

#include "renderer/base/unit_interval.h"
#include "renderer/view/equirect.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

/// The pixel of `count` over [0, 1] that holds `position`.
std::size_t pixel_at(float position, int count) {
  const auto pixel = static_cast<int>(static_cast<double>(position) * count);
  return static_cast<std::size_t>(std::clamp(pixel, 0, count - 1));
}

}  // namespace

// The stamp comes before the reading: what is written in between is then read at the next aim.
MaskSampler::MaskSampler(std::filesystem::path path, double floor)
    : path_(std::move(path)),
      floor_(floor),
      read_at_(stamp()),
      painting_(painting_of(read_weights(path_))) {}

MaskSampler::MaskSampler(WeightImage image, double floor)
    : floor_(floor), painting_(painting_of(std::move(image))) {}

std::optional<MaskSampler::Stamp> MaskSampler::stamp() const {
  std::error_code failure;
  const auto written = std::filesystem::last_write_time(path_, failure);
  if (failure) {
    return std::nullopt;
  }
  const std::uintmax_t bytes = std::filesystem::file_size(path_, failure);
  return failure ? std::nullopt : std::optional(Stamp{.written = written, .bytes = bytes});
}

MaskSampler::Painting MaskSampler::painting_of(WeightImage image) const {
  const double mean = std::accumulate(image.weights.begin(), image.weights.end(), 0.0) /
                      static_cast<double>(image.weights.size());
  // Relative to the largest: a multiple of the mean may be more than a float holds.
  const double largest = *std::max_element(image.weights.begin(), image.weights.end());
  for (float& weight : image.weights) {
    weight = static_cast<float>((weight + floor_ * mean) / largest);
  }
  return {.width = image.width,
          .height = image.height,
          .pixels = {static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height),
                     image.weights}};
}

void MaskSampler::aim(const Aim&) {
  if (path_.empty()) {
    return;
  }
  const std::optional<Stamp> now = stamp();
  if (!now || now == read_at_) {
    return;
  }
  read_at_ = now;
  try {
    painting_ = painting_of(read_weights(path_));
  } catch (const std::exception&) {
    // A file may even vanish while it is read. The last good painting stays.
  }
}

void MaskSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  const double width = 1.0 / painting_.width;
  const double height = 1.0 / painting_.height;
  const auto image_of = [&](const Vec2& point) {
    const PiecewiseConstant2D::Point place = painting_.pixels.sample(point);
    const double x = static_cast<double>(place.column) + static_cast<double>(place.within.x);
    const double y = static_cast<double>(place.row) + static_cast<double>(place.within.y);
    return Vec2(std::min(static_cast<float>(x * width), largest_below_one),
                static_cast<float>(y * height));
  };
  sample_places(points, image_of, samples);
}

double MaskSampler::density_per_sr(const Vec3& direction) const {
  const Vec2 image = equirect_from_direction(direction);
  const double probability = painting_.pixels.probability(pixel_at(image.x, painting_.width),
                                                          pixel_at(image.y, painting_.height));
  return probability * painting_.width * painting_.height * equirect_area_per_sr(direction);
}

}  // namespace foveola
