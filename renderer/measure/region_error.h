// How far an image still is from what it converges to, in a part of it, with the reference's own
// noise taken out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// Pixels of an image, each with its weight; those without weight are not listed.
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
/// NaN where there is none.
struct RegionError {
  /// Mean squared error. Expected to be that against a reference without noise, so it may be
  /// negative by chance where the image is no noisier than the reference.
  double mse = 0.0;
  /// Mean of d^2 / (r^2 + relative_mse_epsilon), with r the mean of both halves; it may be negative
  /// too.
  double relative_mse = 0.0;
  double samples_per_pixel = 0.0;  ///< weighted mean, pixels without samples included; or NaN
  double empty_share = 0.0;        ///< weight of the pixels without samples, of all weight; or NaN
  std::size_t pixels = 0;          ///< pixels that were compared
  std::size_t empty = 0;           ///< pixels without samples
  std::size_t non_finite = 0;      ///< left out since the image or a half is not finite
};

/// With halves A and B, (x - A)(x - B) has the expectation of (x - truth)^2: the same as the
/// squared distance to the halves' mean, less the variance of that mean, (A - B)^2 / 4. All images
/// have the same size; `image` has its sample counts.
RegionError region_error(const FilmImage& image, const ReferenceHalves& reference,
                         const PixelRegion& region);

/// The weighted mean of `values`, one a pixel, over a region; NaN for one without pixels.
double region_mean(const std::vector<float>& values, const PixelRegion& region);

}  // namespace foveola
