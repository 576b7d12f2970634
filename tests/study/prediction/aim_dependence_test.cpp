#include "study/prediction/aim_dependence.h"

#include <gtest/gtest.h>

#include "study/prediction/judged_view.h"

namespace foveola::study {
namespace {

constexpr Vec3 ahead(0.0F, 0.0F, -1.0F);

Aim aim_to(const Vec3& direction) { return aim_at(direction, DisplaySettings{}); }

TEST(AimDependence, SomeMethodsFollowTheGaze) {
  for (const char* method : {"od", "vp", "vp-rect"}) {
    EXPECT_FALSE(follows_gaze(*make_view_sampler(method), aim_to(ahead))) << method;
  }
  for (const char* method : {"fv", "hybrid:0.9*od+0.1*fv"}) {
    EXPECT_TRUE(follows_gaze(*make_view_sampler(method), aim_to(ahead))) << method;
  }
}

TEST(AimDependence, MostMethodsFollowTheHead) {
  EXPECT_FALSE(follows_aim(*make_view_sampler("od"), aim_to(ahead), aim_to(-ahead)));
  for (const char* method : {"vp", "fv", "hybrid:0.9*od+0.1*fv"}) {
    EXPECT_TRUE(follows_aim(*make_view_sampler(method), aim_to(ahead), aim_to(-ahead))) << method;
  }
}

}  // namespace
}  // namespace foveola::study
