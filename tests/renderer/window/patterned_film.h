// A film whose pictures show where they are wrong, and how the processor draws them.
#pragma once

#include <vector>

#include "renderer/film/equirect_film.h"
#include "renderer/image/image.h"
#include "renderer/window/drawing/view_overlays.h"

namespace foveola::test {

/// Samples at places of the film's image, in [0, 1) each way.
void add_samples(EquirectFilm& film, const std::vector<Vec2>& images,
                 const std::vector<Rgb>& radiance, const Workers& workers);

/// A picture of smooth waves and a few sharp edges, in part unsampled.
void paint_pattern(EquirectFilm& film, const Workers& workers);

/// The part of `picture` that a view has, as the processor draws it; but for that share of pixels.
void expect_like_the_processors(const RgbImage& picture, const ShownView& view,
                                const ViewLook& look, const EquirectFilm& film,
                                const Workers& workers, double max_differing_share = 0.001);

}  // namespace foveola::test
