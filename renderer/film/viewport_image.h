// What the display shows of the film.
#pragma once

#include "renderer/base/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Resamples the film to a rectilinear view of width x height pixels, bilinearly, weighting each
/// film pixel by whether it has samples: an unsampled pixel neither darkens nor brightens its
/// neighbours, and where all four are unsampled the view is black, as in the published study. It is
/// right across the seam and over the poles. Linear radiance.
RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height);

/// The same, to the bit, by several threads.
RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        const Workers& workers);

/// The same for an image whose pixels are all known, such as a reference.
RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height);

}  // namespace foveola
