#include <gtest/gtest.h>

#include "analysis/convergence/measurement.h"
#include "analysis/convergence/scorer.h"

namespace foveola::analysis {
namespace {

constexpr IVec2 size{2048, 1024};

class Prediction : public testing::Test {
 protected:
  std::unique_ptr<ViewSampler> aimed(const std::string& method) const {
    std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    sampler->aim({.viewport = viewport_, .gaze = gaze_});
    return sampler;
  }

  double of(const std::string& method, double radius_deg) const {
    const Region disc{.name = "disc", .weight = [&](const Vec3& direction) {
                        return angle_between(gaze_, direction) <= radians(radius_deg) ? 1.0 : 0.0;
                      }};
    return predicted_speed_up(*aimed(method), *aimed("od"), region_on_film(disc, size), size)
        .value_or(0.0);
  }

  AzimuthElevation heading_{.azimuth_rad = 1.0};  // on the horizon
  Vec3 gaze_ = direction_from(heading_);
  Viewport viewport_{head_orientation(heading_), radians(100.0), radians(100.0)};
};

// The published densities: FV has 59.35 times OD's at the gaze, as its normaliser 1091.85 square
// degrees says (64800 / 1091.85), and Reddy's acuity falls beyond 5.79 degrees.
TEST_F(Prediction, IsThatOfThePublishedDensities) {
  EXPECT_NEAR(of("fv", 5.0), 59.3, 0.15);
  EXPECT_NEAR(of("fv", 10.0), 42.8, 0.2);
  EXPECT_NEAR(of("fv", 20.0), 16.3, 0.2);
}

// Some of the pixels' middles lie in the ring that fv-paper leaves out, which is a 40th of a pixel
// wide; the densities differ by less than 2.5 %.
TEST_F(Prediction, OfThePapersPolynomialIsNearlyThatOfItsExactInverse) {
  EXPECT_NEAR(of("fv-paper", 5.0) / of("fv", 5.0), 1.0, 0.001);
  EXPECT_NEAR(of("fv-paper", 10.0) / of("fv", 10.0), 1.0, 0.01);
}

// 2 pi^2 times the density of a plane of 2 tan(50 deg) a side, seen from the distance 1.
TEST_F(Prediction, OfTheViewportIsThatOfItsPlane) { EXPECT_NEAR(of("vp", 0.5), 3.475, 0.01); }

TEST_F(Prediction, IsOneAgainstItself) { EXPECT_DOUBLE_EQ(of("od", 20.0), 1.0); }

TEST_F(Prediction, IsEmptyWhereSamplesNeverFall) {
  const Region sphere{.name = "sphere", .weight = [](const Vec3&) { return 1.0; }};
  EXPECT_FALSE(
      predicted_speed_up(*aimed("fv"), *aimed("od"), region_on_film(sphere, {64, 32}), {64, 32}));
}

}  // namespace
}  // namespace foveola::analysis
