#include "renderer/film/view_pixels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

void expect_levels(double fov_deg, const RadialLens& lens) {
  constexpr int width = 203;  // no whole eights
  constexpr int height = 101;
  constexpr int film_height = 2048;
  constexpr int last_level = 4;
  const Viewport view(head_orientation({}), radians(fov_deg), radians(0.6 * fov_deg), lens);
  ViewPixels pixels(width, height);
  pixels.choose_levels(view, film_height, last_level, 0, 40);
  pixels.choose_levels(view, film_height, last_level, 40, height);
  float highest = 0.0F;
  for (std::uint32_t pixel = 0; pixel < pixels.count(); ++pixel) {
    const Vec2 plane((static_cast<float>(pixel % width) + 0.5F) / width,
                     (static_cast<float>(pixel / width) + 0.5F) / height);
    const float level =
        std::min(level_for(view.sr_per_area(plane) / pixels.count(), film_height), 4.0F);
    EightPixels eight;
    eight.fill(pixel);
    ASSERT_EQ(pixels.points(eight).level[0], level) << fov_deg << " degrees, pixel " << pixel;
    highest = std::max(highest, level);
  }
  EXPECT_EQ(pixels.highest_level(), highest);
}

TEST(ViewPixels, LevelsAreThoseOfTheirSteradians) {
  for (const double fov_deg : {2.0, 15.0, 60.0, 100.0, 150.0, 179.9}) {
    expect_levels(fov_deg, {});
  }
  expect_levels(90.0, {.axis = {0.44F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F});
}

void expect_librarys(const std::vector<double>& numbers) {
  std::vector<float> logs(numbers.size());
  rounded_log2(numbers, logs);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_EQ(logs[i], static_cast<float>(std::log2(numbers[i]))) << numbers[i];
  }
}

TEST(RoundedLog2, IsTheLibrarysRounded) {
  Pcg32 random(3, 5);
  std::vector<double> numbers;
  for (int i = 0; i < 1'000'000; ++i) {
    numbers.push_back(std::exp2(24.0 * random.uniform() - 12.0));
  }
  expect_librarys(numbers);
}

// Around 1 logarithms are small, and floats lie close together.
TEST(RoundedLog2, IsTheLibrarysNextToOne) {
  std::vector<double> numbers;
  for (int exponent = -52; exponent < -1; ++exponent) {
    numbers.push_back(1.0 + std::exp2(exponent));
    numbers.push_back(1.0 - std::exp2(exponent));
  }
  expect_librarys(numbers);
}

// Exact logarithms, ends of the series, and doubles whose logarithms lie in the middle between two
// floats, as near as a double can.
TEST(RoundedLog2, IsTheLibrarysWhereRoundingIsCritical) {
  std::vector<double> numbers = {1e-300, 1e300};
  for (int exponent = -40; exponent <= 40; ++exponent) {
    numbers.push_back(std::exp2(exponent));
    const double root = std::exp2(exponent + 0.5);
    numbers.insert(numbers.end(), {std::nextafter(root, 0.0), root, std::nextafter(root, 1e9)});
  }
  for (float log = 0.5F; log < 4.0F; log += 0.001F) {
    const double middle = 0.5 * (static_cast<double>(log) + std::nextafter(log, 5.0F));
    const double number = std::exp2(middle);
    numbers.insert(numbers.end(),
                   {std::nextafter(number, 0.0), number, std::nextafter(number, 99.0)});
  }
  expect_librarys(numbers);
}

TEST(RoundedLog2, OfNothingIsNothing) { expect_librarys({}); }

/// Eight times the same.
Vec2s middle_of(const EquirectFilm& film, int x, int y) {
  const Vec2 image = (Vec2(x, y) + 0.5F) / Vec2(film.width(), film.height());
  return {all_lanes(image.x), all_lanes(image.y)};
}

/// Where a pixel that may lie beyond the seam or a pole is.
IVec2 on_sphere(const EquirectFilm& film, IVec2 pixel) {
  if (pixel.y < 0 || pixel.y >= film.height()) {
    pixel.y = pixel.y < 0 ? -1 - pixel.y : 2 * film.height() - 1 - pixel.y;
    pixel.x += film.width() / 2;
  }
  return {(pixel.x % film.width() + film.width()) % film.width(), pixel.y};
}

// Films of whole tiles, and of narrow ones at the right and the bottom.
TEST(TilesInView, HoldEverythingWithinATileOfAMark) {
  for (const IVec2& size : {IVec2(256, 128), IVec2(100, 50), IVec2(70, 33), IVec2(20, 40)}) {
    const EquirectFilm film(size.x, size.y);
    for (int y = 0; y < size.y; y += 7) {
      for (int x = 0; x < size.x; x += 5) {
        TilesInView view(film);
        view.mark(middle_of(film, x, y));
        const std::vector<std::uint32_t> tiles = view.around();
        for (const int dy : {-31, -24, -1, 0, 1, 24, 31}) {
          for (const int dx : {-31, -24, -1, 0, 1, 24, 31}) {
            const IVec2 near = on_sphere(film, IVec2(x + dx, y + dy));
            ASSERT_TRUE(
                std::binary_search(tiles.begin(), tiles.end(), film.tile_of(near.x, near.y)))
                << size.x << "x" << size.y << ": " << near.x << ", " << near.y << " from " << x
                << ", " << y;
          }
        }
      }
    }
  }
}

TEST(TilesInView, LeaveOutWhatIsFurtherAway) {
  const EquirectFilm film(512, 256);
  TilesInView view(film);
  EXPECT_THAT(view.around(), IsEmpty());
  view.mark(middle_of(film, 100, 100));
  EXPECT_THAT(view.around(), ElementsAre(34, 35, 36, 50, 51, 52, 66, 67, 68));
  view.forget();
  EXPECT_THAT(view.around(), IsEmpty());
  view.mark(middle_of(film, 511, 100));
  EXPECT_THAT(view.around(), ElementsAre(32, 46, 47, 48, 62, 63, 64, 78, 79));
}

}  // namespace

}  // namespace foveola
