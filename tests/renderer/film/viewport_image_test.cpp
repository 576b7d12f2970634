#include "renderer/film/viewport_image.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// A smooth function of direction: spherical harmonics of the first and second degree.
Rgb smooth(const Vec3& d) {
  return {0.5F + 0.5F * d.x, 0.5F + 0.5F * d.y * d.z, 0.5F + 0.25F * (3.0F * d.y * d.y - 1.0F)};
}

RgbImage panorama_of_smooth(int width, int height) {
  RgbImage panorama(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      panorama.at(x, y) = smooth(
          direction_from_equirect({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5F) / static_cast<float>(height)}));
    }
  }
  return panorama;
}

constexpr RadialLens headset_lens{.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F};

class Heading : public testing::TestWithParam<std::pair<double, double>> {
 protected:
  /// The view's largest error against the function that the panorama shows.
  float largest_error(const RgbImage& panorama, double fov_deg, const RadialLens& lens) const {
    constexpr int width = 90;
    constexpr int height = 70;
    const auto [azimuth_deg, elevation_deg] = GetParam();
    const Viewport viewport(head_orientation({.azimuth_rad = radians(azimuth_deg),
                                              .elevation_rad = radians(elevation_deg)}),
                            radians(fov_deg), radians(0.8 * fov_deg), lens);
    const RgbImage view = viewport_image(panorama, viewport, width, height);
    float largest = 0.0F;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Vec2 plane((static_cast<float>(x) + 0.5F) / width,
                         (static_cast<float>(y) + 0.5F) / height);
        largest =
            std::max(largest, glm::distance(view.at(x, y), smooth(viewport.direction(plane))));
      }
    }
    return largest;
  }
};

TEST_P(Heading, ASmoothPanoramaIsShownAsItIs) {
  const RgbImage panorama = panorama_of_smooth(512, 256);
  for (const double fov_deg : {40.0, 100.0}) {
    for (const RadialLens& lens : {RadialLens{}, headset_lens, mirrored(headset_lens)}) {
      EXPECT_LT(largest_error(panorama, fov_deg, lens), 1e-3F)
          << fov_deg << " degrees, k1 " << lens.k1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AheadSeamAndPoles, Heading,
                         testing::Values(std::pair{0.0, 0.0}, std::pair{180.0, 0.0},
                                         std::pair{40.0, 90.0}, std::pair{-120.0, -90.0},
                                         std::pair{179.0, 60.0}));

class SparseFilm : public testing::Test {
 protected:
  void sample(int x, int y, const Rgb& color) {
    const Vec2 image((static_cast<float>(x) + 0.5F) / 64.0F,
                     (static_cast<float>(y) + 0.5F) / 32.0F);
    film_.number(std::vector<ViewSample>{{direction_from_equirect(image), image}}, batch_,
                 workers_);
    film_.add(batch_, std::vector<Rgb>{color}, workers_);
  }

  RgbImage shown(int width, int height, UnsampledPixels unsampled = UnsampledPixels::black) const {
    return viewport_image(film_, ahead_, width, height, unsampled, workers_);
  }

  const Workers workers_{1};
  EquirectFilm film_{64, 32};
  NumberedBatch batch_;
  const Viewport ahead_{head_orientation({}), radians(20.0), radians(20.0)};
};

TEST_F(SparseFilm, IsBlackWhereNothingWasSampled) {
  for (const Rgb& pixel : shown(16, 16).pixels) {
    EXPECT_EQ(pixel, Rgb(0.0F));
  }
}

// One pixel known: around it the view has its colour to the full, further away it is black.
TEST_F(SparseFilm, UnsampledPixelsDoNotDarkenTheirNeighbours) {
  sample(32, 16, Rgb(0.25F, 0.5F, 1.0F));
  const RgbImage view = shown(64, 64);
  int known = 0;
  for (const Rgb& pixel : view.pixels) {
    if (pixel != Rgb(0.0F)) {
      EXPECT_LT(glm::distance(pixel, Rgb(0.25F, 0.5F, 1.0F)), 1e-6F);
      ++known;
    }
  }
  EXPECT_GT(known, 100);
  EXPECT_LT(known, 64 * 64);
}

TEST_F(SparseFilm, UnsampledPixelsAreFilledFromThePyramidIfAsked) {
  const Rgb color(0.25F, 0.5F, 1.0F);
  sample(32, 16, color);
  for (const Rgb& pixel : shown(64, 64, UnsampledPixels::filled).pixels) {
    EXPECT_LT(glm::distance(pixel, color), 1e-6F);
  }
  EXPECT_EQ(
      viewport_image(EquirectFilm(64, 32), ahead_, 4, 4, UnsampledPixels::filled, workers_).pixels,
      RgbImage(4, 4).pixels);
}

// Between two known colours an unsampled pixel takes from both, and what is known stays as it is.
TEST_F(SparseFilm, FillingLeavesWhatIsKnown) {
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      if ((x + y) % 2 == 0) {
        sample(x, y, x < 32 ? Rgb(0.0F) : Rgb(1.0F));
      }
    }
  }
  const Viewport wide(head_orientation({}), radians(90.0), radians(90.0));
  const RgbImage filled = viewport_image(film_, wide, 64, 64, UnsampledPixels::filled, workers_);
  EXPECT_LT(filled.at(20, 32).r, 0.01F);
  EXPECT_GT(filled.at(43, 32).r, 0.99F);
  for (const Rgb& pixel : filled.pixels) {
    EXPECT_GE(pixel.r, 0.0F);
    EXPECT_LE(pixel.r, 1.0F);
  }
}

// A view of few pixels averages the film over each: eight samples of a chequerboard must give grey.
TEST_F(SparseFilm, SmallViewsAverage) {
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      sample(x, y, (x + y) % 2 == 0 ? Rgb(0.0F) : Rgb(1.0F));
    }
  }
  const Viewport wide(head_orientation({}), radians(90.0), radians(90.0));
  for (const Rgb& pixel :
       viewport_image(film_, wide, 4, 4, UnsampledPixels::black, workers_).pixels) {
    EXPECT_NEAR(pixel.r, 0.5F, 1e-5F);
  }
}

TEST_F(SparseFilm, FilmAndPanoramaAreShownAlike) {
  const RgbImage panorama = panorama_of_smooth(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      sample(x, y, panorama.at(x, y));
    }
  }
  EXPECT_EQ(shown(20, 20).pixels, viewport_image(panorama, ahead_, 20, 20).pixels);
}

}  // namespace
}  // namespace foveola
