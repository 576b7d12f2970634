#include "study/participant/visible_difference.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

constexpr int size = 100;
const Viewport ahead(head_orientation({}), radians(90.0), radians(90.0));
const Vec3 forward(0.0F, 0.0F, -1.0F);

RgbImage grey(float value) {
  RgbImage image(size, size);
  std::fill(image.pixels.begin(), image.pixels.end(), Rgb(value));
  return image;
}

RgbImage checkerboard(float dark, float bright) {
  RgbImage image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      image.at(x, y) = Rgb((x + y) % 2 == 0 ? dark : bright);
    }
  }
  return image;
}

TEST(RegionAround, HoldsThePixelsWithinTheRadius) {
  // The circle of 10 degrees in the plane of a 90-degree view, 100 pixels wide and 2 high and wide.
  const Region region = region_around(ahead, size, size, forward, 10.0, 0.1);
  const double radius_px = std::tan(radians(10.0)) * size / 2.0;
  EXPECT_NEAR(static_cast<double>(region.pixels.size()), std::numbers::pi * radius_px * radius_px,
              12.0);
  EXPECT_EQ(region.patches.size(), region.pixels.size());
}

TEST(RegionAround, GathersPixelsInPatches) {
  // A pixel in the middle is 1.146 degrees wide: 4.6 degrees are four pixels.
  const Region region = region_around(ahead, size, size, forward, 20.0, 4.6);
  std::size_t full = 0;
  std::size_t covered = 0;
  for (const Region::Patch& patch : region.patches) {
    EXPECT_LE(patch.end - patch.begin, 16U);
    EXPECT_EQ(patch.begin, covered);
    covered = patch.end;
    full += patch.end - patch.begin == 16 ? 1 : 0;
  }
  EXPECT_EQ(covered, region.pixels.size());
  EXPECT_GT(full, region.patches.size() / 2);
}

TEST(RegionAround, IsEmptyForWhatIsNotInView) {
  const Region region = region_around(ahead, size, size, {0.0F, 0.0F, 1.0F}, 10.0, 1.0);
  EXPECT_TRUE(region.pixels.empty());
  EXPECT_EQ(visible_difference(grey(0.0F), grey(0.0F), region, {}),
            std::numeric_limits<double>::infinity());
}

TEST(VisibleDifference, OfUniformImagesIsTheirDistance) {
  const Region region = whole_view(ahead, size, size);
  EXPECT_NEAR(visible_difference(grey(0.75F), grey(0.5F), region, {}), 0.25, 1e-6);
  EXPECT_NEAR(visible_contrast(grey(0.75F), region, {}), 0.0, 1e-6);
}

TEST(VisibleDifference, SeesFineNoiseInFinePatchesOnly) {
  const Region fine = region_around(ahead, size, size, forward, 20.0, 0.25);
  const Region coarse = region_around(ahead, size, size, forward, 20.0, 4.6);
  EXPECT_NEAR(visible_difference(checkerboard(0.4F, 0.6F), grey(0.5F), fine, {}), 0.1, 1e-6);
  EXPECT_LT(visible_difference(checkerboard(0.4F, 0.6F), grey(0.5F), coarse, {}), 0.01);
  EXPECT_NEAR(visible_contrast(checkerboard(0.4F, 0.6F), fine, {}), 0.1, 1e-3);
}

TEST(VisibleDifference, CountsByTheCorticalMagnificationAtTheEccentricity) {
  // Two pixels of a region differ, one at a time; the weights must be as (e2 / (e + e2))^2.
  const Region view = whole_view(ahead, size, size);
  const std::size_t at_gaze = 50 * size + 50;
  const std::size_t away = 50 * size + 95;
  const Eye eye{.gaze = view.patches[at_gaze].direction, .half_magnification_deg = 3.67};
  const auto difference_at = [&](std::size_t pixel) {
    RgbImage image = grey(0.5F);
    image.pixels[pixel] = Rgb(1.0F);
    return visible_difference(image, grey(0.5F), view, eye);
  };
  const double eccentricity_deg =
      degrees(angle_between(view.patches[at_gaze].direction, view.patches[away].direction));
  EXPECT_NEAR(difference_at(away) / difference_at(at_gaze), 3.67 / (eccentricity_deg + 3.67), 1e-3);
}

}  // namespace
}  // namespace foveola::study
