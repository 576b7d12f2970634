#include "renderer/measure/region_error.h"

#include <cassert>

#include "renderer/measure/error_metrics.h"

namespace foveola {

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

}  // namespace foveola
