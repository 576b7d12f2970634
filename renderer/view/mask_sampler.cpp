#include "renderer/view/mask_sampler.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <system_error>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

constexpr double largest_eccentricity_deg = 179.0;

PiecewiseConstant2D pixels_in_reach(WeightImage& image, double degrees_per_pixel) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      // To the farthest corner of the pixel.
      const double across = std::abs(x + 0.5 - 0.5 * image.width) + 0.5;
      const double upright = std::abs(y + 0.5 - 0.5 * image.height) + 0.5;
      if (degrees_per_pixel * std::hypot(across, upright) > largest_eccentricity_deg) {
        image.weights[static_cast<std::size_t>(y) * image.width + x] = 0.0F;
      }
    }
  }
  return {static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height),
          image.weights};
}

/// The pixel of `count` over [0, 1] that holds `position`.
std::size_t pixel_at(float position, int count) {
  const auto pixel = static_cast<int>(static_cast<double>(position) * count);
  return static_cast<std::size_t>(std::clamp(pixel, 0, count - 1));
}

}  // namespace

// The stamp precedes the reading: a change in between is then read at the next aim.
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
  // Relative to the maximum: a multiple of the mean may exceed a float.
  const double largest = *std::ranges::max_element(image.weights);
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
    // A file may even vanish during reading. The last good mask stays.
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

MapSampler::MapSampler(WeightImage image, double extent_deg)
    : width_(image.width),
      height_(image.height),
      degrees_per_pixel_(2.0 * extent_deg / std::max(image.width, image.height)),
      pixels_(pixels_in_reach(image, degrees_per_pixel_)) {
  if (pixels_.total() == 0.0) {
    throw Error("fv-map", "no pixel within 179 degrees of the gaze has any weight",
                "paint nearer to the middle of the map, or choose a smaller extent");
  }
}

void MapSampler::aim(const Aim& aim) {
  gaze_ = GazeFrame(glm::normalize(aim.gaze), aim.viewport.head());
}

void MapSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  const double turns_per_pixel = degrees_per_pixel_ / 360.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PiecewiseConstant2D::Point place = pixels_.sample(points[i]);
    const double x =
        static_cast<double>(place.column) + static_cast<double>(place.within.x) - 0.5 * width_;
    const double y =
        0.5 * height_ - static_cast<double>(place.row) - static_cast<double>(place.within.y);
    const double distance = std::hypot(x, y);
    const auto [sine, cosine] =
        sine_cosine_of_turns(static_cast<float>(turns_per_pixel * distance));
    const auto along = distance > 0.0 ? static_cast<float>(sine / distance) : 0.0F;
    const Vec3 direction =
        gaze_.to_world({along * static_cast<float>(x), along * static_cast<float>(y), cosine});
    samples[i] = {.direction = direction, .image = equirect_from_direction(direction)};
  }
}

double MapSampler::density_per_sr(const Vec3& direction) const {
  const double e = degrees(angle_between(direction, gaze_.ahead));
  const DVec3 local(gaze_.to_local(direction));
  const double radius = std::hypot(local.x, local.y);
  const double pixels_per_unit = radius > 0.0 ? e / (degrees_per_pixel_ * radius) : 0.0;
  const double column = std::floor(0.5 * width_ + pixels_per_unit * local.x);
  const double row = std::floor(0.5 * height_ - pixels_per_unit * local.y);
  if (column < 0.0 || column >= width_ || row < 0.0 || row >= height_ ||
      e > largest_eccentricity_deg) {
    return 0.0;
  }
  const double probability =
      pixels_.probability(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  return foveola::density_per_sr(probability / (degrees_per_pixel_ * degrees_per_pixel_), e,
                                 EccentricityMeasure::planar);
}

}  // namespace foveola
