#include "study/person/session/object_pick.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

Vec3 towards(double azimuth_deg) {
  return direction_from({.azimuth_rad = radians(azimuth_deg), .elevation_rad = 0.0});
}

const std::vector<OfferedObject> offered = {{.name = "lamp", .direction = towards(0.0)},
                                            {.name = "vase", .direction = towards(60.0)},
                                            {.name = "chair", .direction = towards(180.0)}};

TEST(ObjectPick, FollowsTheView) {
  EXPECT_EQ(object_ahead(offered, towards(25.0)), 0U);
  EXPECT_EQ(object_ahead(offered, towards(35.0)), 1U);
  EXPECT_EQ(object_ahead(offered, towards(-100.0)), 2U);
  for (std::size_t i = 0; i < offered.size(); ++i) {
    EXPECT_EQ(object_ahead(offered, offered[i].direction), i);
  }
}

TEST(ObjectPick, RingsEachObjectTheHighlightedOneOnTop) {
  const std::vector<OfferRing> rings = rings_of(offered, 1);
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_TRUE(rings.back().is_highlighted);
  EXPECT_EQ(rings.back().direction, towards(60.0));
  EXPECT_FALSE(rings.front().is_highlighted);
  EXPECT_NEAR(rings.front().radius_rad, radians(4.0), 1e-6);
}

TEST(ObjectPick, TheChosenOnesRingIsHighlighted) {
  EXPECT_EQ(ring_of(offered[2]).direction, towards(180.0));
  EXPECT_TRUE(ring_of(offered[2]).is_highlighted);
}

}  // namespace
}  // namespace foveola::study
