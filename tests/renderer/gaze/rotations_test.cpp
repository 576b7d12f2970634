#include "renderer/gaze/rotations.h"

#include <numbers>

#include <gtest/gtest.h>

namespace foveola {
namespace {

const DVec3 right(1.0, 0.0, 0.0);
const DVec3 up(0.0, 1.0, 0.0);
const DVec3 back(0.0, 0.0, 1.0);

void expect_near(const DVec3& a, const DVec3& b) { EXPECT_LT(glm::distance(a, b), 1e-15); }

TEST(Rotations, AQuarterTurnIsRightHanded) {
  expect_near(rotation_between(right, up), 0.5 * std::numbers::pi * back);
  expect_near(rotated(up, 0.5 * std::numbers::pi * right), back);
}

TEST(Rotations, LeadFromOneToTheOther) {
  const DVec3 from = glm::normalize(DVec3(0.3, -0.2, -1.0));
  const DVec3 to = glm::normalize(DVec3(-0.7, 0.4, -0.1));
  expect_near(rotated(from, rotation_between(from, to)), to);
}

TEST(Rotations, TinyOnesAreExact) {
  const DVec3 to = glm::normalize(DVec3(1.0, 1e-9, 0.0));
  EXPECT_NEAR(glm::length(rotation_between(right, to)), 1e-9, 1e-22);
}

TEST(Rotations, NoneChangesNothing) {
  EXPECT_EQ(rotation_between(up, up), DVec3(0.0));
  EXPECT_EQ(rotation_between(up, -up), DVec3(0.0));
  EXPECT_EQ(rotated(up, DVec3(0.0)), up);
}

}  // namespace
}  // namespace foveola
