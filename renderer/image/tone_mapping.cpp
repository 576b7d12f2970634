#include "renderer/image/tone_mapping.h"

#include <algorithm>
#include <cmath>

namespace foveola {

float linear_from_srgb(float encoded) {
  const float x = std::clamp(encoded, 0.0F, 1.0F);
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

float exposure_scale(double stops) { return static_cast<float>(std::exp2(stops)); }

RgbImage display_image(const RgbImage& linear, double exposure_stops, ToneCurve curve) {
  const float scale = exposure_scale(exposure_stops);
  RgbImage display(linear.width, linear.height);
  std::transform(linear.pixels.begin(), linear.pixels.end(), display.pixels.begin(),
                 [scale, curve](const Rgb& color) {
                   return Rgb(display_from_linear(scale * color.r, curve),
                              display_from_linear(scale * color.g, curve),
                              display_from_linear(scale * color.b, curve));
                 });
  return display;
}

}  // namespace foveola
