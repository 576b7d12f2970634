// How far an image is from another one.
#pragma once

#include <cstddef>

#include "renderer/image/image.h"

namespace foveola {

/// The means and errors are NaN where no pixel could be compared.
struct ErrorMetrics {
  double rmse = 0.0;          ///< root of the mean squared difference over pixels and channels
  double relative_mse = 0.0;  ///< mean of d^2 / (r^2 + epsilon)
  double mean_image = 0.0;    ///< mean over pixels and channels
  double mean_reference = 0.0;
  std::size_t pixels = 0;      ///< pixels that were compared
  std::size_t non_finite = 0;  ///< pixels left out since one of the two is not finite
};

/// The epsilon of relative_mse (Rousselle et al. 2011 and most since).
inline constexpr double relative_mse_epsilon = 0.01;

enum class PixelWeight {
  uniform,
  solid_angle,  ///< weighted by the cosine of the latitude, for equirect images
};

/// Both images must have the same size. Throws Error otherwise.
ErrorMetrics compare_images(const RgbImage& image, const RgbImage& reference, PixelWeight weight);

}  // namespace foveola
