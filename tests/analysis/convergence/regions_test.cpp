#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analysis/convergence/scorer.h"

namespace foveola::analysis {
namespace {

constexpr IVec2 region_size{1024, 512};
using std::numbers::pi;

double total_weight(const PixelRegion& region) {
  double sum = 0.0;
  for (const PixelRegion::Pixel& pixel : region.pixels) {
    sum += pixel.weight;
  }
  return sum;
}

/// A region on a film: its weights are cosines of latitude.
double steradians(const PixelRegion& region) {
  return total_weight(region) * 2.0 * pi * pi / region_size.x / region_size.y;
}

class Regions : public testing::Test {
 protected:
  const Region& named(const std::string& name) const {
    const auto found = std::find_if(regions_.begin(), regions_.end(),
                                    [&](const Region& region) { return region.name == name; });
    EXPECT_NE(found, regions_.end()) << name;
    return *found;
  }

  AzimuthElevation heading_{.azimuth_rad = 3.0, .elevation_rad = 0.4};  // over the seam
  Vec3 gaze_ = direction_from(heading_);
  Viewport viewport_{head_orientation(heading_), radians(100.0), radians(100.0)};
  std::vector<Region> regions_ = regions_around(gaze_, viewport_);
};

TEST_F(Regions, HaveTheirSolidAnglesOnTheFilm) {
  for (const int radius_deg : {5, 10, 20}) {
    const Region& disc = named(std::to_string(radius_deg) + "deg");
    const double cap = 2.0 * pi * (1.0 - std::cos(radians(radius_deg)));
    EXPECT_NEAR(steradians(region_on_film(disc, region_size)) / cap, 1.0, 0.02) << disc.name;
  }
  // A square pyramid of half angle a on both sides: 4 asin(sin^2 a).
  const double pyramid = 4.0 * std::asin(std::pow(std::sin(radians(50.0)), 2.0));
  EXPECT_NEAR(steradians(region_on_film(named("viewport"), region_size)) / pyramid, 1.0, 0.005);
  EXPECT_NEAR(steradians(region_on_film(named("sphere"), region_size)) / (4.0 * pi), 1.0, 1e-4);
}

TEST_F(Regions, HaveTheirSolidAnglesOnTheDisplay) {
  constexpr int view_size = 400;
  const auto on_view = [&](const std::string& name) {
    return total_weight(region_on_view(named(name), viewport_, view_size)) /
           (view_size * view_size);
  };
  EXPECT_NEAR(on_view("10deg") / (2.0 * pi * (1.0 - std::cos(radians(10.0)))), 1.0, 0.01);
  EXPECT_NEAR(on_view("viewport") / (4.0 * std::asin(std::pow(std::sin(radians(50.0)), 2.0))), 1.0,
              1e-3);
}

// Reddy's acuity is 7.49 / 10^2 at 30 degrees.
TEST_F(Regions, AcuityWeighsTheViewport) {
  const Region& acuity = named("acuity");
  EXPECT_EQ(acuity.weight(gaze_), 1.0);
  const Vec3 up = viewport_.head() * Vec3(0.0F, std::sin(radians(30.0)), -std::cos(radians(30.0)));
  EXPECT_NEAR(acuity.weight(up), 0.0749, 1e-5);
  EXPECT_EQ(acuity.weight(-gaze_), 0.0);
}

TEST_F(Regions, OnlyTheSphereIsBeyondTheDisplay) {
  for (const Region& region : regions_) {
    EXPECT_EQ(region.is_in_view, region.name != "sphere") << region.name;
  }
}

}  // namespace
}  // namespace foveola::analysis
