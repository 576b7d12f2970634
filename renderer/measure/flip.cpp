#include "renderer/measure/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {
namespace {

/// One channel of an image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        values(static_cast<std::size_t>(width_px) * height_px) {}

  /// Beyond its borders the image is extended by its edge pixels.
  float at(int x, int y) const {
    return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width +
                  std::clamp(x, 0, width - 1)];
  }
};

using Planes = std::array<Plane, 3>;
/// An odd number of weights, the middle one for the pixel itself.
using Kernel = std::vector<float>;

Plane filter_along(const Plane& plane, const Kernel& kernel, const IVec2& step) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane filtered(plane.width, plane.height);
  std::size_t i = 0;
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x, ++i) {
      float sum = 0.0F;
      for (int k = -radius; k <= radius; ++k) {
        sum +=
            kernel[static_cast<std::size_t>(k + radius)] * plane.at(x + k * step.x, y + k * step.y);
      }
      filtered.values[i] = sum;
    }
  }
  return filtered;
}

Plane filter(const Plane& plane, const Kernel& across, const Kernel& down) {
  return filter_along(filter_along(plane, across, {1, 0}), down, {0, 1});
}

std::vector<double> weights_of(int radius, const std::function<double(int)>& weight) {
  std::vector<double> weights;
  for (int k = -radius; k <= radius; ++k) {
    weights.push_back(weight(k));
  }
  return weights;
}

// --- Colour spaces ---

/// Linear sRGB to XYZ, with the primaries of IEC 61966-2-1 and D65 as the authors round them.
DVec3 xyz_of(const DVec3& rgb) {
  return {(10135552.0 * rgb.r + 8788810.0 * rgb.g + 4435075.0 * rgb.b) / 24577794.0,
          (2613072.0 * rgb.r + 8788810.0 * rgb.g + 887015.0 * rgb.b) / 12288897.0,
          (1425312.0 * rgb.r + 8788810.0 * rgb.g + 70074185.0 * rgb.b) / 73733382.0};
}

const DVec3& white_xyz() {
  static const DVec3 white = xyz_of(DVec3(1.0));
  return white;
}

DVec3 linear_of(const DVec3& xyz) {
  // The columns are the XYZ of the three primaries.
  static const DMat3 rgb_from_xyz = glm::inverse(
      DMat3(xyz_of({1.0, 0.0, 0.0}), xyz_of({0.0, 1.0, 0.0}), xyz_of({0.0, 0.0, 1.0})));
  return rgb_from_xyz * xyz;
}

/// The linear opponent space of the contrast sensitivity (section 4.1).
DVec3 opponent_of(const DVec3& xyz) {
  const DVec3 relative = xyz / white_xyz();
  return {116.0 * relative.y - 16.0, 500.0 * (relative.x - relative.y),
          200.0 * (relative.y - relative.z)};
}

DVec3 xyz_of_opponent(const DVec3& opponent) {
  const double y = (opponent.x + 16.0) / 116.0;
  return DVec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * white_xyz();
}

/// CIE L*a*b* (CIE 15:2004), with chroma reduced in the dark by Hunt's effect.
DVec3 hunt_adjusted_lab(const DVec3& linear) {
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29.0;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
  };
  const DVec3 relative = xyz_of(linear) / white_xyz();
  const double lightness = 116.0 * f(relative.y) - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f(relative.x) - f(relative.y)),
          0.01 * lightness * 200.0 * (f(relative.y) - f(relative.z))};
}

/// For large differences (Abasi et al. 2020, "Distance metrics for very large color differences").
double hyab_distance(const DVec3& a, const DVec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

Planes opponent_planes(const RgbImage& image) {
  const Plane empty(image.width, image.height);
  Planes planes = {empty, empty, empty};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgb& encoded = image.pixels[i];
    const DVec3 opponent = opponent_of(xyz_of(
        {linear_from_srgb(encoded.r), linear_from_srgb(encoded.g), linear_from_srgb(encoded.b)}));
    for (int channel = 0; channel < 3; ++channel) {
      planes[static_cast<std::size_t>(channel)].values[i] = static_cast<float>(opponent[channel]);
    }
  }
  return planes;
}

// --- Blur by the eye: the colour pipeline (section 4.1) ---

/// Contrast sensitivity as a sum of Gaussians over degrees: a sqrt(pi / b) exp(-pi^2 d^2 / b).
struct Gaussian {
  double a;
  double b;
};
constexpr std::array<Gaussian, 2> achromatic = {{{1.0, 0.0047}, {0.0, 1e-5}}};
constexpr std::array<Gaussian, 2> red_green = {{{1.0, 0.0053}, {0.0, 1e-5}}};
constexpr std::array<Gaussian, 2> blue_yellow = {{{34.1, 0.04}, {13.5, 0.025}}};

Plane seen(const Plane& plane, const std::array<Gaussian, 2>& sensitivity, double per_degree) {
  constexpr double pi = std::numbers::pi;
  // Three standard deviations of the widest of all.
  const double widest_deg = 3.0 * std::sqrt(blue_yellow[0].b / (2.0 * pi * pi));
  const int radius = static_cast<int>(std::ceil(widest_deg * per_degree));
  Plane sum(plane.width, plane.height);
  double total = 0.0;
  for (const Gaussian& part : sensitivity) {
    if (part.a > 0.0) {
      const std::vector<double> weights = weights_of(radius, [&](int k) {
        const double distance_deg = k / per_degree;
        return std::exp(-pi * pi * distance_deg * distance_deg / part.b);
      });
      const Kernel kernel(weights.begin(), weights.end());
      const double amplitude = part.a * std::sqrt(pi / part.b);
      const Plane filtered = filter(plane, kernel, kernel);
      double kernel_sum = 0.0;
      for (const float weight : kernel) {
        kernel_sum += weight;
      }
      total += amplitude * kernel_sum * kernel_sum;
      for (std::size_t i = 0; i < sum.values.size(); ++i) {
        sum.values[i] += static_cast<float>(amplitude) * filtered.values[i];
      }
    }
  }
  for (float& value : sum.values) {
    value /= static_cast<float>(total);
  }
  return sum;
}

std::vector<DVec3> seen_colors(const Planes& opponent, double per_degree) {
  const Planes planes = {seen(opponent[0], achromatic, per_degree),
                         seen(opponent[1], red_green, per_degree),
                         seen(opponent[2], blue_yellow, per_degree)};
  std::vector<DVec3> colors;
  colors.reserve(planes[0].values.size());
  for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
    const DVec3 linear =
        linear_of(xyz_of_opponent({planes[0].values[i], planes[1].values[i], planes[2].values[i]}));
    colors.push_back(hunt_adjusted_lab(glm::clamp(linear, 0.0, 1.0)));
  }
  return colors;
}

/// Maps distances of Lab colours to [0, 1]: small ones, which are frequent, get most of the range.
double color_error(const DVec3& a, const DVec3& b) {
  constexpr double exponent = 0.7;
  constexpr double knee = 0.4;
  constexpr double error_at_knee = 0.95;
  static const double largest = std::pow(
      hyab_distance(hunt_adjusted_lab({0.0, 1.0, 0.0}), hunt_adjusted_lab({0.0, 0.0, 1.0})),
      exponent);
  const double distance = std::pow(hyab_distance(a, b), exponent);
  const double at_knee = knee * largest;
  return distance < at_knee
             ? error_at_knee * distance / at_knee
             : error_at_knee + (1.0 - error_at_knee) * (distance - at_knee) / (largest - at_knee);
}

// --- Edges and points: the feature pipeline (section 4.2) ---

struct FeatureKernels {
  Kernel smooth;
  Kernel edge;
  Kernel point;
};

/// Scales the positive weights to a sum of 1 and the negative ones to -1. In double, where the tail
/// of a kernel far narrower than a pixel still has distinct weights.
Kernel balanced(const std::vector<double>& weights) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double weight : weights) {
    (weight > 0.0 ? positive : negative) += std::abs(weight);
  }
  return transformed(weights, [&](const double weight) {
    return weight == 0.0 ? 0.0F : static_cast<float>(weight / (weight > 0.0 ? positive : negative));
  });
}

FeatureKernels feature_kernels(double per_degree) {
  constexpr double feature_width_deg = 0.082;
  const double sigma = 0.5 * feature_width_deg * per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  const auto gaussian = [sigma](int k) { return std::exp(-k * k / (2.0 * sigma * sigma)); };
  return {.smooth = balanced(weights_of(radius, gaussian)),
          .edge = balanced(weights_of(radius, [&](int k) { return -k * gaussian(k); })),
          .point = balanced(weights_of(
              radius, [&](int k) { return (k * k / (sigma * sigma) - 1.0) * gaussian(k); }))};
}

/// Each pixel's similarity to an edge, or to a point.
Plane feature_strength(const Plane& luminance, const Kernel& detector, const Kernel& smooth) {
  Plane strength = filter(luminance, detector, smooth);
  const Plane down = filter(luminance, smooth, detector);
  for (std::size_t i = 0; i < strength.values.size(); ++i) {
    strength.values[i] = std::hypot(strength.values[i], down.values[i]);
  }
  return strength;
}

Plane relative_luminance(Plane achromatic_plane) {
  for (float& value : achromatic_plane.values) {
    value = (value + 16.0F) / 116.0F;
  }
  return achromatic_plane;
}

std::vector<double> feature_errors(const Plane& a, const Plane& b, double per_degree) {
  const FeatureKernels kernels = feature_kernels(per_degree);
  const Plane luminance_a = relative_luminance(a);
  const Plane luminance_b = relative_luminance(b);
  const Plane edge_a = feature_strength(luminance_a, kernels.edge, kernels.smooth);
  const Plane edge_b = feature_strength(luminance_b, kernels.edge, kernels.smooth);
  const Plane point_a = feature_strength(luminance_a, kernels.point, kernels.smooth);
  const Plane point_b = feature_strength(luminance_b, kernels.point, kernels.smooth);
  std::vector<double> errors;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double strongest = std::max(std::abs(edge_a.values[i] - edge_b.values[i]),
                                      std::abs(point_a.values[i] - point_b.values[i]));
    errors.push_back(std::sqrt(strongest / std::numbers::sqrt2));
  }
  return errors;
}

// --- Exposures of an image of high dynamic range ---

void require_radiance(const RgbImage& image, const char* name) {
  for (const Rgb& pixel : image.pixels) {
    if (!(std::min({pixel.r, pixel.g, pixel.b}) >= 0.0F) ||
        !std::isfinite(pixel.r + pixel.g + pixel.b)) {
      throw Error("HDR-FLIP", fmt::format("{} has negative or infinite pixels, or NaN", name),
                  "compare radiances that are finite and not negative");
    }
  }
}

/// In stops.
struct ExposureRange {
  double first;
  double last;
};

/// The exposures at which the maximum and the median luminance become 0.85 (section 3.1).
ExposureRange exposure_range(const RgbImage& reference) {
  constexpr double shown = 2.1189;  ///< the linear value that filmic() maps to 0.85
  std::vector<double> luminances =
      transformed(reference.pixels, [&](const Rgb& pixel) { return xyz_of(DVec3(pixel)).y; });
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  const double brightest = *std::max_element(middle, luminances.end());
  if (!(brightest > 0.0)) {
    throw Error("HDR-FLIP", "the reference is black", "compare with one that shows something");
  }
  const double first = std::log2(shown / brightest);
  return {first, *middle > 0.0 ? std::log2(shown / *middle) : first};
}

}  // namespace

std::vector<float> flip_errors(const RgbImage& image, const RgbImage& reference,
                               double pixels_per_degree) {
  if (image.width != reference.width || image.height != reference.height) {
    throw Error("FLIP",
                fmt::format("the image has {}x{} pixels and the reference {}x{}", image.width,
                            image.height, reference.width, reference.height),
                "compare images of the same size");
  }
  if (!(pixels_per_degree > 0.0) || !std::isfinite(pixels_per_degree)) {
    throw Error("FLIP", fmt::format("{} pixels per degree is not a density", pixels_per_degree),
                "give a number above zero");
  }
  const Planes opponent = opponent_planes(image);
  const Planes opponent_reference = opponent_planes(reference);
  const std::vector<DVec3> colors = seen_colors(opponent, pixels_per_degree);
  const std::vector<DVec3> reference_colors = seen_colors(opponent_reference, pixels_per_degree);
  const std::vector<double> features =
      feature_errors(opponent[0], opponent_reference[0], pixels_per_degree);
  std::vector<float> errors;
  errors.reserve(colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    errors.push_back(static_cast<float>(
        std::pow(color_error(colors[i], reference_colors[i]), 1.0 - features[i])));
  }
  return errors;
}

std::vector<float> hdr_flip_errors(const RgbImage& image, const RgbImage& reference,
                                   double pixels_per_degree) {
  require_radiance(image, "the image");
  require_radiance(reference, "the reference");
  const ExposureRange range = exposure_range(reference);
  const int exposures = std::max(2, static_cast<int>(std::ceil(range.last - range.first)));
  std::vector<float> largest(image.pixels.size(), 0.0F);
  for (int i = 0; i < exposures; ++i) {
    const double stops = std::lerp(range.first, range.last, i / (exposures - 1.0));
    const std::vector<float> errors =
        flip_errors(display_image(image, stops, ToneCurve::filmic),
                    display_image(reference, stops, ToneCurve::filmic), pixels_per_degree);
    std::transform(errors.begin(), errors.end(), largest.begin(), largest.begin(),
                   [](float a, float b) { return std::max(a, b); });
  }
  return largest;
}

double pixels_per_degree(double fov_rad, int width) {
  return width / (2.0 * std::tan(0.5 * fov_rad)) * radians(1.0);
}

}  // namespace foveola
