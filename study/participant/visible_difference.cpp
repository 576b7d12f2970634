#include "study/participant/visible_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

Vec3 direction_of_pixel(const Viewport& viewport, int width, int height, int x, int y) {
  return viewport.direction({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                             (static_cast<float>(y) + 0.5F) / static_cast<float>(height)});
}

/// A pixel of a region, on its way into a patch.
struct PlacedPixel {
  int patch = 0;
  std::size_t index = 0;
  Vec3 direction{0.0F};
};

/// Gathers the pixels that belong to one patch.
Region gathered(std::vector<PlacedPixel> placed) {
  std::stable_sort(placed.begin(), placed.end(),
                   [](const PlacedPixel& a, const PlacedPixel& b) { return a.patch < b.patch; });
  Region region;
  region.pixels.reserve(placed.size());
  for (std::size_t begin = 0; begin < placed.size();) {
    std::size_t end = begin;
    Vec3 sum(0.0F);
    while (end < placed.size() && placed[end].patch == placed[begin].patch) {
      region.pixels.push_back(placed[end].index);
      sum += placed[end].direction;
      ++end;
    }
    region.patches.push_back({.begin = begin, .end = end, .direction = glm::normalize(sum)});
    begin = end;
  }
  return region;
}

/// How many pixels about patch_deg are where `plane` is.
int patch_width_px(const Viewport& viewport, int width, const Vec2& plane, double patch_deg) {
  const Vec2 neighbour = plane + Vec2(1.0F / static_cast<float>(width), 0.0F);
  const double pixel_deg =
      degrees(angle_between(viewport.direction(plane), viewport.direction(neighbour)));
  return std::max(1, static_cast<int>(std::lround(patch_deg / pixel_deg)));
}

Rgb mean_color(const RgbImage& image, const Region& region, const Region::Patch& patch) {
  Rgb sum(0.0F);
  for (std::size_t i = patch.begin; i < patch.end; ++i) {
    sum += image.pixels[region.pixels[i]];
  }
  return sum / static_cast<float>(patch.end - patch.begin);
}

double weight(const Region::Patch& patch, const Eye& eye) {
  const double cosine = std::clamp(glm::dot(patch.direction, eye.gaze), -1.0F, 1.0F);
  const double eccentricity_deg = degrees(std::acos(cosine));
  const double magnification =
      eye.half_magnification_deg / (eccentricity_deg + eye.half_magnification_deg);
  return static_cast<double>(patch.end - patch.begin) * magnification * magnification;
}

double mean_square(const Rgb& color) { return glm::dot(color, color) / 3.0; }

}  // namespace

Region region_around(const Viewport& viewport, int width, int height, const Vec3& center,
                     double radius_deg, double patch_deg) {
  const std::optional<Vec2> plane = viewport.project(center);
  if (!plane) {
    return {};
  }
  const int patch_px = patch_width_px(viewport, width, *plane, patch_deg);
  const int patches_across = (width + patch_px - 1) / patch_px;
  const auto smallest_cosine = static_cast<float>(std::cos(radians(radius_deg)));
  std::vector<PlacedPixel> placed;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 direction = direction_of_pixel(viewport, width, height, x, y);
      if (glm::dot(direction, center) >= smallest_cosine) {
        placed.push_back({.patch = (y / patch_px) * patches_across + x / patch_px,
                          .index = static_cast<std::size_t>(y) * width + x,
                          .direction = direction});
      }
    }
  }
  return gathered(std::move(placed));
}

Region whole_view(const Viewport& viewport, int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * height;
  Region region;
  region.pixels.resize(count);
  std::iota(region.pixels.begin(), region.pixels.end(), std::size_t{0});
  region.patches.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    region.patches.push_back(
        {.begin = i, .end = i + 1, .direction = direction_of_pixel(viewport, width, height, x, y)});
  }
  return region;
}

double visible_difference(const RgbImage& presented, const RgbImage& expected, const Region& region,
                          const Eye& eye) {
  double sum = 0.0;
  double total_weight = 0.0;
  for (const Region::Patch& patch : region.patches) {
    const double w = weight(patch, eye);
    sum +=
        w * mean_square(mean_color(presented, region, patch) - mean_color(expected, region, patch));
    total_weight += w;
  }
  return total_weight > 0.0 ? std::sqrt(sum / total_weight)
                            : std::numeric_limits<double>::infinity();
}

double visible_contrast(const RgbImage& image, const Region& region, const Eye& eye) {
  DVec3 sum(0.0);
  double sum_of_squares = 0.0;
  double total_weight = 0.0;
  for (const Region::Patch& patch : region.patches) {
    const double w = weight(patch, eye);
    const Rgb color = mean_color(image, region, patch);
    sum += w * DVec3(color);
    sum_of_squares += w * mean_square(color);
    total_weight += w;
  }
  if (total_weight <= 0.0) {
    return 0.0;
  }
  const DVec3 mean = sum / total_weight;
  return std::sqrt(std::max(0.0, sum_of_squares / total_weight - glm::dot(mean, mean) / 3.0));
}

}  // namespace foveola::study
