// Adaptive sampling: fewer samples where nobody would see the difference.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"

namespace foveola {

/// When the noise that is left in a pixel is no longer seen: once its standard error is below
/// `contrast` of its mean at the gaze, and elsewhere below `contrast` over Reddy's relative acuity
/// there.
struct VisibleNoise {
  double contrast = 0.01;  ///< positive; Weber fractions of luminance are near 1 %
  /// Linear luminance on the display, after exposure_stops, that darker pixels count as: below,
  /// displays are black.
  double darkest = 0.01;
  double exposure_stops = 0.0;
  std::uint32_t least_samples = 16;  ///< samples of a neighbour before its variance is believed
};

/// Sends samples away from pixels that are done, to others up to 16 pixels around; those that find
/// none are left out. The film must keep variances.
///
/// A rule that stops when a pixel's own samples agree prefers samples that agree: dark pixels with
/// rare bright paths would stay too dark. Here the variances of a pixel's eight neighbours decide,
/// and of the pixel itself only how many samples it has. That is not strictly unbiased: a pixel's
/// samples decide whether its neighbours are done, and so whether theirs are sent to it. Where one
/// sample in ten is bright, 120 renders found (0.03 +- 0.05) % of the mean to come of it; a rule by
/// a pixel's own samples costs 3 % there, and the tests allow 0.75 %.
///
/// seed, together with a sample's place in `samples`, decides where it goes.
void redirect_samples(const EquirectFilm& film, const Vec3& gaze, const VisibleNoise& noise,
                      std::uint32_t seed, std::vector<ViewSample>& samples, const Workers& workers);

}  // namespace foveola
