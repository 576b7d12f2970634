// Errors of an image against another image, or against its reference in a region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// Weighted pixels of an image; pixels without weight are not listed.
struct PixelRegion {
  struct Pixel {
    std::uint32_t index = 0;  ///< y * width + x
    float weight = 0.0F;      ///< above zero
  };
  std::vector<Pixel> pixels;
};

/// Two renders of the same image with independent noise.
struct ReferenceHalves {
  RgbImage first;
  RgbImage second;
};

/// Errors are means over the weighted pixels that have samples and are finite, and over channels;
/// NaN without such pixels.
struct RegionError {
  /// Mean squared error. Its expectation is that against a noise-free reference, so it may be
  /// negative by chance if the image is no noisier than the reference.
  double mse = 0.0;
  /// Mean of d^2 / (r^2 + relative_mse_epsilon), with r the mean of both halves; it may be negative
  /// too.
  double relative_mse = 0.0;
  double samples_per_pixel = 0.0;  ///< weighted mean, including pixels without samples; or NaN
  double empty_share = 0.0;        ///< share of the weight on pixels without samples; or NaN
  std::size_t pixels = 0;          ///< number of pixels compared
  std::size_t empty = 0;           ///< number of pixels without samples
  std::size_t non_finite = 0;      ///< number left out because the image or a half is not finite
};

/// With halves A and B, (x - A)(x - B) has the expectation of (x - truth)^2: the squared distance
/// to the halves' mean, less the variance of that mean, (A - B)^2 / 4. All images have the same
/// size; `image` has its sample counts.
RegionError region_error(const FilmImage& image, const ReferenceHalves& reference,
                         const PixelRegion& region);

/// The weighted mean of `values`, one per pixel, over a region; NaN for an empty one.
double region_mean(const std::vector<float>& values, const PixelRegion& region);

/// Means and errors are NaN if no pixel could be compared.
struct ErrorMetrics {
  double rmse = 0.0;          ///< root of the mean squared difference over pixels and channels
  double relative_mse = 0.0;  ///< mean of d^2 / (r^2 + epsilon)
  double mean_image = 0.0;    ///< mean over pixels and channels
  double mean_reference = 0.0;
  std::size_t pixels = 0;      ///< number of pixels compared
  std::size_t non_finite = 0;  ///< number of pixels left out because one image is not finite
};

/// The epsilon of relative_mse (Rousselle et al. 2011 and most since).
inline constexpr double relative_mse_epsilon = 0.01;

enum class PixelWeight {
  uniform,
  solid_angle,  ///< weighted by the cosine of the latitude, for equirect images
};

/// Compares images of the same size. Throws Error otherwise.
ErrorMetrics compare_images(const RgbImage& image, const RgbImage& reference, PixelWeight weight);

}  // namespace foveola
