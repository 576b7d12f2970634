// Views of films of noise, held against the definition of what they show, which is worked out here
// in double from pixels, angles and differences alone.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include "renderer/film/viewport_resampler.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

using std::numbers::pi;
constexpr int film_width = 256;
constexpr int film_height = 128;
constexpr int view_width = 45;
constexpr int view_height = 38;

struct Looking {
  double azimuth_deg;
  double elevation_deg;
  double fov_deg;
  RadialLens lens;
};

std::ostream& operator<<(std::ostream& out, const Looking& looking) {
  return out << looking.azimuth_deg << ", " << looking.elevation_deg << " degrees, "
             << looking.fov_deg << " wide, k1 " << looking.lens.k1;
}

/// Colour times weight, and weight.
struct Known {
  DVec3 color{0.0};
  double weight = 0.0;

  Known& operator+=(const Known& other) {
    color += other.color;
    weight += other.weight;
    return *this;
  }
};

Known operator*(double factor, const Known& known) {
  return {factor * known.color, factor * known.weight};
}

class Definition : public testing::TestWithParam<Looking> {
 protected:
  /// A film in which one pixel of `every` has samples.
  static EquirectFilm sampled(std::uint32_t every) {
    const Workers workers(1);
    EquirectFilm film(film_width, film_height);
    std::vector<ViewSample> samples;
    for (int y = 0; y < film_height; ++y) {
      for (int x = 0; x < film_width; ++x) {
        if (mix(static_cast<std::uint32_t>(y * film_width + x)) % every == 0) {
          samples.push_back(in_pixel(x, y, film, 1).front());
        }
      }
    }
    add_samples(samples, film, workers);
    return film;
  }

  /// What is seen at a place on the display, in pixels from its top left corner.
  static DVec3 direction(double x, double y) {
    const auto& [azimuth_deg, elevation_deg, fov_deg, lens] = GetParam();
    const double half_size = std::tan(fov_deg * pi / 360.0);
    const double right = 2.0 * (x / view_width - lens.axis.x) * half_size;
    const double up = -2.0 * (y / view_height - lens.axis.y) * half_size;
    const double d2 = right * right + up * up;
    const double larger = 1.0 + lens.k1 * d2 + lens.k2 * d2 * d2;
    const double a = azimuth_deg * pi / 180.0;
    const double e = elevation_deg * pi / 180.0;
    const DVec3 ahead(std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a));
    const DVec3 to_right(std::cos(a), 0.0, std::sin(a));
    return glm::normalize(ahead + larger * right * to_right +
                          larger * up * glm::cross(to_right, ahead));
  }

  /// Steradians of the pixel around there.
  static double pixel_sr(double x, double y) {
    constexpr double step = 1e-3;
    const DVec3 across = (direction(x + step, y) - direction(x - step, y)) / (2.0 * step);
    const DVec3 down = (direction(x, y + step) - direction(x, y - step)) / (2.0 * step);
    return glm::length(glm::cross(across, down));
  }

  /// A square of 2^level pixels' side; beyond the seam and the poles too.
  static Known cell(const EquirectFilm& film, int level, int x, int y) {
    const int side = 1 << level;
    if (y < 0 || y >= film_height / side) {
      y = y < 0 ? -1 - y : 2 * (film_height / side) - 1 - y;
      x += film_width / side / 2;
    }
    x = (x + film_width / side) % (film_width / side);
    Known sum;
    for (int row = y * side; row < (y + 1) * side; ++row) {
      for (int column = x * side; column < (x + 1) * side; ++column) {
        if (film.sample_count(column, row) > 0) {
          sum += {DVec3(film.mean(column, row)), 1.0};
        }
      }
    }
    return 1.0 / (side * side) * sum;
  }

  static Known bilinear(const EquirectFilm& film, int level, const DVec2& image) {
    const DVec2 place = image * DVec2(film_width >> level, film_height >> level) - 0.5;
    const DVec2 corner = glm::floor(place);
    Known sum;
    for (const int down : {0, 1}) {
      for (const int right : {0, 1}) {
        const DVec2 distance = glm::abs(place - corner - DVec2(right, down));
        sum += (1.0 - distance.x) * (1.0 - distance.y) *
               cell(film, level, static_cast<int>(corner.x) + right,
                    static_cast<int>(corner.y) + down);
      }
    }
    return sum;
  }

  static Known shown(const EquirectFilm& film, int x, int y, UnsampledPixels unsampled) {
    const DVec3 d = direction(x + 0.5, y + 0.5);
    const DVec2 image(0.5 + std::atan2(d.x, -d.z) / (2.0 * pi), 0.5 - std::asin(d.y) / pi);
    const double pixel_rad = std::sqrt(pixel_sr(x + 0.5, y + 0.5));
    const double level = std::max(0.0, std::log2(pixel_rad / (pi / film_height)));
    const int finer = static_cast<int>(level);
    Known sum = (1.0 - (level - finer)) * bilinear(film, finer, image);
    sum += (level - finer) * bilinear(film, finer + 1, image);
    for (int l = finer + 1; unsampled == UnsampledPixels::filled && sum.weight < 0.999; ++l) {
      const Known coarser = bilinear(film, l, image);
      if (coarser.weight > 0.0) {
        sum += (1.0 - sum.weight) * std::min(std::exp2(2.0 * l), 1.0 / coarser.weight) * coarser;
      }
    }
    return sum;
  }

  /// Compares every pixel; how far its colour may be off grows as less is known there. Returns how
  /// many were neither black nor nearly so.
  static int compare(const EquirectFilm& film, UnsampledPixels unsampled, double tolerance) {
    const Workers workers(1);
    const auto& [azimuth_deg, elevation_deg, fov_deg, lens] = GetParam();
    const AzimuthElevation heading = {.azimuth_rad = radians(azimuth_deg),
                                      .elevation_rad = radians(elevation_deg)};
    const Viewport viewport(head_orientation(heading), radians(fov_deg), radians(fov_deg), lens);
    const RgbImage view =
        viewport_image(film, viewport, view_width, view_height, unsampled, workers);
    int known = 0;
    for (int y = 0; y < view_height; ++y) {
      for (int x = 0; x < view_width; ++x) {
        const Known expected = shown(film, x, y, unsampled);
        const DVec3 color(view.at(x, y));
        if (expected.weight > 0.01) {
          const double error = glm::distance(color, expected.color / expected.weight);
          EXPECT_LT(error, tolerance / expected.weight) << x << ", " << y;
          ++known;
        } else if (expected.weight == 0.0) {
          EXPECT_EQ(color, DVec3(0.0)) << x << ", " << y;
        }
      }
    }
    return known;
  }
};

TEST_P(Definition, HoldsWhereEverythingIsKnown) {
  EXPECT_EQ(compare(sampled(1), UnsampledPixels::black, 2e-4), view_width * view_height);
}

TEST_P(Definition, HoldsWhereLittleIsKnown) {
  EXPECT_GT(compare(sampled(10), UnsampledPixels::black, 2e-4), view_width * view_height / 8);
}

// What is nearly known may be filled or not, for a rounding.
TEST_P(Definition, HoldsForUnsampledPixelsThatAreFilled) {
  EXPECT_EQ(compare(sampled(10), UnsampledPixels::filled, 2e-3), view_width * view_height);
}

constexpr RadialLens headset{.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F};

INSTANTIATE_TEST_SUITE_P(
    AheadSeamPolesAndLenses, Definition,
    testing::Values(Looking{0.0, 0.0, 100.0, {}}, Looking{180.0, 0.0, 100.0, {}},
                    Looking{35.0, 88.0, 100.0, {}}, Looking{-130.0, -75.0, 60.0, {}},
                    Looking{179.0, 30.0, 20.0, {}}, Looking{-60.0, 10.0, 160.0, {}},
                    Looking{170.0, -50.0, 90.0, headset}));

}  // namespace
}  // namespace foveola
