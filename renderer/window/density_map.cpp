#include "renderer/window/density_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foveola {

DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width,
                       int height) {
  constexpr double decades = 2.0;
  constexpr double uniform = 0.25 * std::numbers::inv_pi;
  DensityMap map{.width = width, .height = height};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 plane = (Vec2(x, y) + 0.5F) / Vec2(width, height);
      const double density = sampler.density_per_sr(viewport.direction(plane)) / uniform;
      const double shown = density > 0.0 ? 0.5 + 0.5 * std::log10(density) / decades : 0.0;
      map.values.push_back(static_cast<float>(std::clamp(shown, 0.0, 1.0)));
    }
  }
  return map;
}

Rgb density_color(float value) {
  const Rgb color(3.0F * value - 1.0F, 1.5F - std::abs(3.0F * value - 1.5F), 2.0F - 3.0F * value);
  return glm::clamp(color, 0.0F, 1.0F);
}

}  // namespace foveola
