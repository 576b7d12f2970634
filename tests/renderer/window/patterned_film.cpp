#include "tests/renderer/window/patterned_film.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/view/equirect.h"

namespace foveola::test {
namespace {

Rgb pattern(const Vec2& image) {
  const float wave = 0.5F + 0.5F * std::sin(60.0F * image.x) * std::cos(40.0F * image.y);
  const float edge = std::fmod(image.x * 16.0F, 1.0F) < 0.5F ? 0.2F : 1.5F;
  return {wave, 0.3F * edge, 0.5F * wave * edge};
}

}  // namespace

void add_samples(EquirectFilm& film, const std::vector<Vec2>& images,
                 const std::vector<Rgb>& radiance, const Workers& workers) {
  std::vector<ViewSample> samples;
  for (const Vec2& image : images) {
    samples.push_back({.direction = direction_from_equirect(image), .image = image});
  }
  NumberedBatch batch;
  film.number(samples, batch, workers);
  film.add(batch, radiance, workers);
}

void paint_pattern(EquirectFilm& film, const Workers& workers) {
  std::vector<Vec2> images;
  std::vector<Rgb> radiance;
  Pcg32 random(3, 5);
  for (int i = 0; i < 200'000; ++i) {
    const auto u = static_cast<float>(random.uniform());
    images.emplace_back(u, static_cast<float>(random.uniform()));
    radiance.push_back(pattern(images.back()));
  }
  add_samples(film, images, radiance, workers);
}

void expect_like_the_processors(const RgbImage& picture, const ShownView& view,
                                const ViewLook& look, const EquirectFilm& film,
                                const Workers& workers, double max_differing_share) {
  const RgbImage expected = display_image(
      viewport_image(film, view.viewport, view.part.size.x, view.part.size.y,
                     look.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black,
                     workers),
      look.exposure_stops, look.curve);
  // A step of the display is 1/255, half of which is its rounding; 16-bit texels add a part in
  // two thousand, and positions on the card a thousandth of a pixel.
  constexpr float tolerance = 1.5F / 255.0F;
  int differing = 0;
  double sum = 0.0;
  const int top = picture.height - view.part.origin.y - view.part.size.y;
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      const Rgb difference =
          glm::abs(picture.at(view.part.origin.x + x, top + y) - expected.at(x, y));
      const float largest = std::max({difference.r, difference.g, difference.b});
      differing += largest > tolerance ? 1 : 0;
      sum += largest;
    }
  }
  const double pixels = static_cast<double>(expected.width) * expected.height;
  EXPECT_LE(differing, max_differing_share * pixels);
  EXPECT_LE(sum / pixels, 0.7 / 255.0);
}

}  // namespace foveola::test
