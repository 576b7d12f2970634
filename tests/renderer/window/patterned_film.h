// A film whose pictures show where they are wrong, and how the processor draws them.
#pragma once

#include "renderer/film/equirect_film.h"
#include "renderer/image/image.h"
#include "renderer/window/view_overlays.h"

namespace foveola::test {

/// A picture of smooth waves and a few sharp edges, in part unsampled.
void paint_pattern(EquirectFilm& film, const Workers& workers);

/// The part of `picture` that a view has, as the processor draws it.
void expect_like_the_processors(const RgbImage& picture, const ShownView& view,
                                const ViewLook& look, const EquirectFilm& film,
                                const Workers& workers);

}  // namespace foveola::test
