#include "renderer/view/map_sampler.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/view/equirect.h"
#include "renderer/view/radial_distribution.h"

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

}  // namespace

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
