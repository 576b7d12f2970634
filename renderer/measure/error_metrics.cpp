#include "renderer/measure/error_metrics.h"

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
