#include "analysis/convergence/prediction.h"

#include <cmath>
#include <numbers>

#include "renderer/view/density_around.h"
#include "renderer/view/equirect.h"

namespace foveola::analysis {
namespace {

/// Weighted mean of a pixel's variance after one sample on the film, relative to that of a sample;
/// infinite where a pixel is never reached.
double mean_inverse_probability(const ViewSampler& sampler, const PixelRegion& region,
                                const IVec2& size) {
  const double pixel_area = 2.0 * std::numbers::pi * std::numbers::pi / size.x / size.y;
  double sum = 0.0;
  double total_weight = 0.0;
  for (const auto& [index, weight] : region.pixels) {
    const int y = static_cast<int>(index) / size.x;
    const int x = static_cast<int>(index) % size.x;
    const double v = (y + 0.5) / size.y;
    const double sr = pixel_area * std::sin(std::numbers::pi * v);
    const Vec3 middle = direction_from_equirect(Vec2((x + 0.5) / size.x, v));
    sum += weight / (density_around(sampler, middle) * sr);
    total_weight += weight;
  }
  return sum / total_weight;
}

}  // namespace

std::optional<double> predicted_speed_up(const ViewSampler& method, const ViewSampler& baseline,
                                         const PixelRegion& region, const IVec2& size) {
  const double speed_up = mean_inverse_probability(baseline, region, size) /
                          mean_inverse_probability(method, region, size);
  return speed_up > 0.0 && std::isfinite(speed_up) ? std::optional(speed_up) : std::nullopt;
}

}  // namespace foveola::analysis
