#include "renderer/film/viewport_image.h"

#include <array>
#include <cmath>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Rows of the view that one task makes.
constexpr std::size_t row_block = 16;

struct Weighted {
  Rgb color;
  bool known;  ///< whether the pixel has a value at all
};

/// The pixel (x, y) of an equirect image, where x may lie beyond the seam and y beyond a pole: over
/// the pole the same row comes back half an image further.
template <typename PixelAt>
Weighted wrapped(const PixelAt& pixel_at, int width, int height, int x, int y) {
  if (y < 0 || y >= height) {
    y = y < 0 ? -1 - y : 2 * height - 1 - y;
    x += width / 2;
  }
  if (x < 0) {
    x += width;
  } else if (x >= width) {
    x -= width;
  }
  return pixel_at(x, y);
}

/// The bilinear mean of the four pixels around `image` that have a value; black if none has.
template <typename PixelAt>
Rgb bilinear(const PixelAt& pixel_at, int width, int height, const Vec2& image) {
  const float x = image.x * static_cast<float>(width) - 0.5F;
  const float y = image.y * static_cast<float>(height) - 0.5F;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const float across = x - static_cast<float>(left);
  const float down = y - static_cast<float>(top);
  const std::array<float, 4> weights = {(1.0F - across) * (1.0F - down), across * (1.0F - down),
                                        (1.0F - across) * down, across * down};
  Rgb sum(0.0F);
  float total = 0.0F;
  for (int corner = 0; corner < 4; ++corner) {
    const Weighted pixel = wrapped(pixel_at, width, height, left + corner % 2, top + corner / 2);
    if (pixel.known) {
      sum += weights[static_cast<std::size_t>(corner)] * pixel.color;
      total += weights[static_cast<std::size_t>(corner)];
    }
  }
  return total > 0.0F ? sum / total : Rgb(0.0F);
}

/// The rows [begin, end) of `view`.
template <typename PixelAt>
void resample(const PixelAt& pixel_at, const IVec2& film_size, const Viewport& viewport,
              RgbImage& view, int begin, int end) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Vec2 plane((static_cast<float>(x) + 0.5F) / static_cast<float>(view.width),
                       (static_cast<float>(y) + 0.5F) / static_cast<float>(view.height));
      const Vec2 image = equirect_from_direction(viewport.direction(plane));
      view.at(x, y) = bilinear(pixel_at, film_size.x, film_size.y, image);
    }
  }
}

auto pixels_of(const EquirectFilm& film) {
  return [&film](int x, int y) {
    const FilmPixel pixel = film.pixel(x, y);
    return Weighted{.color = pixel.mean, .known = pixel.samples > 0};
  };
}

}  // namespace

RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height) {
  RgbImage view(width, height);
  resample(pixels_of(film), {film.width(), film.height()}, viewport, view, 0, height);
  return view;
}

RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        const Workers& workers) {
  RgbImage view(width, height);
  workers.for_each_block(static_cast<std::size_t>(height), row_block,
                         [&](std::size_t begin, std::size_t end) {
                           resample(pixels_of(film), {film.width(), film.height()}, viewport, view,
                                    static_cast<int>(begin), static_cast<int>(end));
                         });
  return view;
}

RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height) {
  const auto pixel_at = [&panorama](int x, int y) {
    return Weighted{.color = panorama.at(x, y), .known = true};
  };
  RgbImage view(width, height);
  resample(pixel_at, {panorama.width, panorama.height}, viewport, view, 0, height);
  return view;
}

}  // namespace foveola
