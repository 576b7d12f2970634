#include "renderer/film/viewport_image.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/film/view_pixels.h"
#include "renderer/film/viewport_resampler.h"

namespace foveola {
namespace {

/// An image whose pixels are all known, as a pyramid.
SpherePlanes<PremultipliedTexel> pyramid_over(const RgbImage& panorama, int levels) {
  SpherePlanes<PremultipliedTexel> cells(panorama.width, panorama.height, levels);
  for (int y = 0; y < panorama.height; ++y) {
    for (int x = 0; x < panorama.width; ++x) {
      cells.set(0, x, y, {panorama.at(x, y), 1.0F});
    }
  }
  for (int level = 1; level < levels; ++level) {
    const auto below = [&](int x, int y) { return *cells.at(level - 1, x, y); };
    for (int y = 0; y < cells.height(level); ++y) {
      for (int x = 0; x < cells.width(level); ++x) {
        cells.set(level, x, y,
                  mean_of_square(x, y, cells.width(level - 1), cells.height(level - 1), below));
      }
    }
  }
  return cells;
}

}  // namespace

RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers) {
  ViewportResampler resampler(film, {.width = width, .height = height, .unsampled = unsampled});
  return resampler.show(viewport, workers);
}

RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height) {
  const auto longest_side = static_cast<unsigned>(std::max(panorama.width, panorama.height));
  const int single_cell_level = std::bit_width(longest_side - 1);
  ViewPixels pixels(width, height);
  pixels.place(viewport, 0, height);
  pixels.choose_levels(viewport, panorama.height, single_cell_level, 0, height);
  const int highest = static_cast<int>(std::ceil(pixels.highest_level()));
  const SpherePlanes<PremultipliedTexel> cells = pyramid_over(panorama, highest + 1);
  RgbImage view(width, height);
  for (std::size_t first = 0; first < view.pixels.size(); first += lane_count) {
    const ViewPoints points = pixels.points_from(first);
    Vec3s color;
    shown_colors(cells, std::span(&points, 1), UnsampledPixels::black, std::span(&color, 1));
    Vec3Lanes shown;
    shown.store(color);
    for (std::size_t pixel = first; pixel < std::min(first + lane_count, view.pixels.size());
         ++pixel) {
      view.pixels[pixel] = shown.at(pixel - first);
    }
  }
  return view;
}

}  // namespace foveola
