#include "renderer/measure/region_error.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

double row_weight(int y, int height, PixelWeight weight) {
  return weight == PixelWeight::uniform ? 1.0 : std::sin(std::numbers::pi * (y + 0.5) / height);
}

}  // namespace

RegionError region_error(const FilmImage& image, const ReferenceHalves& reference,
                         const PixelRegion& region) {
  assert(image.samples.size() == image.color.pixels.size());
  assert(reference.first.pixels.size() == image.color.pixels.size());
  assert(reference.second.pixels.size() == image.color.pixels.size());
  RegionError error;
  double compared_weight = 0.0;
  double empty_weight = 0.0;
  double total_weight = 0.0;
  double samples = 0.0;
  DVec3 squared(0.0);
  DVec3 relative(0.0);
  for (const auto& [index, weight] : region.pixels) {
    const double w = weight;
    total_weight += w;
    samples += w * image.samples[index];
    const Rgb& value = image.color.pixels[index];
    const Rgb& first = reference.first.pixels[index];
    const Rgb& second = reference.second.pixels[index];
    if (image.samples[index] == 0) {
      ++error.empty;
      empty_weight += w;
    } else if (!is_finite(value) || !is_finite(first) || !is_finite(second)) {
      ++error.non_finite;
    } else {
      const DVec3 product = (DVec3(value) - DVec3(first)) * (DVec3(value) - DVec3(second));
      const DVec3 truth = 0.5 * (DVec3(first) + DVec3(second));
      squared += w * product;
      relative += w * product / (truth * truth + relative_mse_epsilon);
      compared_weight += w;
      ++error.pixels;
    }
  }
  constexpr double channels = 3.0;
  error.mse = (squared.x + squared.y + squared.z) / (channels * compared_weight);
  error.relative_mse = (relative.x + relative.y + relative.z) / (channels * compared_weight);
  error.samples_per_pixel = samples / total_weight;
  error.empty_share = empty_weight / total_weight;
  return error;
}

double region_mean(const std::vector<float>& values, const PixelRegion& region) {
  double sum = 0.0;
  double total_weight = 0.0;
  for (const auto& [index, weight] : region.pixels) {
    sum += static_cast<double>(weight) * values[index];
    total_weight += weight;
  }
  return sum / total_weight;
}

ErrorMetrics compare_images(const RgbImage& image, const RgbImage& reference, PixelWeight weight) {
  if (image.width != reference.width || image.height != reference.height) {
    throw Error("compare",
                fmt::format("the image has {}x{} pixels and the reference {}x{}", image.width,
                            image.height, reference.width, reference.height),
                "compare images of the same size");
  }
  ErrorMetrics metrics;
  double total_weight = 0.0;
  DVec3 squared(0.0);
  DVec3 relative(0.0);
  DVec3 sum_image(0.0);
  DVec3 sum_reference(0.0);
  for (int y = 0; y < image.height; ++y) {
    const double w = row_weight(y, image.height, weight);
    for (int x = 0; x < image.width; ++x) {
      if (!is_finite(image.at(x, y)) || !is_finite(reference.at(x, y))) {
        ++metrics.non_finite;
        continue;
      }
      const DVec3 value(image.at(x, y));
      const DVec3 truth(reference.at(x, y));
      const DVec3 difference = value - truth;
      squared += w * difference * difference;
      relative += w * difference * difference / (truth * truth + relative_mse_epsilon);
      sum_image += w * value;
      sum_reference += w * truth;
      total_weight += w;
      ++metrics.pixels;
    }
  }
  const auto mean = [total_weight](const DVec3& sum) {
    return (sum.x + sum.y + sum.z) / (3.0 * total_weight);
  };
  metrics.rmse = std::sqrt(mean(squared));
  metrics.relative_mse = mean(relative);
  metrics.mean_image = mean(sum_image);
  metrics.mean_reference = mean(sum_reference);
  return metrics;
}

}  // namespace foveola
