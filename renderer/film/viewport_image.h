// One image of what the display shows; ViewportResampler makes one after another.
#pragma once

#include "renderer/base/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/shown_color.h"
#include "renderer/image/image.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Pixels of a display's image where nobody asks for others.
inline constexpr IVec2 usual_view_size{640, 640};

/// Resamples the film to a view of width x height pixels, trilinearly: a pixel of the display is
/// read from the levels of the film's pyramid whose cells are as high as it is. Film pixels are
/// weighted by whether they have samples, so an unsampled one neither darkens nor brightens its
/// neighbours. Right across the seam and over the poles, for sizes that both 32 and the levels used
/// divide; other sizes are off by less than a cell at the seam of the coarser levels. Linear
/// radiance.
RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers);

/// Resamples an image whose pixels are all known, such as a reference.
RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height);

}  // namespace foveola
