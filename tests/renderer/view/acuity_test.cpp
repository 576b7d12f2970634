#include "renderer/view/acuity.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(ReddyAcuity, IsOneInTheFoveaAndFallsBeyond) {
  EXPECT_EQ(reddy_acuity(0.0), 1.0);
  EXPECT_EQ(reddy_acuity(5.79), 1.0);
  EXPECT_NEAR(reddy_acuity(5.7900001), 1.0, 1.7e-4);  // the paper's constants join to 1.6e-4
  EXPECT_NEAR(reddy_acuity(20.0), 7.49 / 49.0, 1e-12);
  EXPECT_NEAR(reddy_acuity(80.0), 7.49 / 625.0, 1e-12);
}

// 1 / (48 (1/48 + 0.022 e)) by hand at 10 degrees: 0.0208333 / 0.2408333.
TEST(LinearResolutionModel, IsTheInverseOfTheResolvedAngle) {
  const AcuityModel model = linear_resolution_model(0.022);
  EXPECT_EQ(model.at(0.0), 1.0);
  EXPECT_NEAR(model.at(10.0), 0.08650519, 1e-8);
  EXPECT_EQ(model.default_exponent, 2.0);
}

TEST(LinearFallOffModel, FallsInAStraightLineBetweenItsKnees) {
  const AcuityModel model = linear_fall_off_model(10.0, 20.0, 0.05);
  EXPECT_EQ(model.at(0.0), 1.0);
  EXPECT_EQ(model.at(10.0), 1.0);
  EXPECT_NEAR(model.at(15.0), 0.525, 1e-12);
  EXPECT_NEAR(model.at(20.0), 0.05, 1e-12);
  EXPECT_NEAR(model.at(90.0), 0.05, 1e-12);
  EXPECT_EQ(model.reach_deg, 180.0);
  EXPECT_EQ(linear_fall_off_model(10.0, 20.0, 0.0).reach_deg, 20.0);
}

}  // namespace
}  // namespace foveola
