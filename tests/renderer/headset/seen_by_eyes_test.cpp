#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/headset/eye_views.h"

namespace foveola {
namespace {

XrView eye(double left_deg, double right_deg, const Quat& orientation) {
  const auto angle = [](double degrees) { return static_cast<float>(radians(degrees)); };
  return {XR_TYPE_VIEW,
          nullptr,
          {{orientation.x, orientation.y, orientation.z, orientation.w}, {0.0F, 0.0F, 0.0F}},
          {angle(left_deg), angle(right_deg), angle(45.0), angle(-45.0)}};
}

const Quat ahead(1.0F, 0.0F, 0.0F, 0.0F);

/// Hides all to the right of this place on an eye's plane.
HiddenTriangles right_of(float x) {
  return {{x, -9.0F}, {9.0F, -9.0F}, {9.0F, 9.0F}, {x, -9.0F}, {9.0F, 9.0F}, {x, 9.0F}};
}

struct Seen {
  std::array<XrView, 2> eyes;
  Quat head;
  FieldOfView both;
  std::shared_ptr<const SeenPart> part;

  Seen(const std::array<XrView, 2>& seeing, const Quat& turned,
       const std::array<HiddenTriangles, 2>& hidden)
      : eyes(seeing),
        head(turned),
        both(field_of_view_of_both(eyes, head)),
        part(seen_by_eyes(eyes, head, both, hidden)) {}
};

TEST(SeenByEyes, IsAllThatLensesWithoutEdgesShow) {
  EXPECT_EQ(Seen({eye(-45, 45, ahead), eye(-45, 45, ahead)}, ahead, {}).part, nullptr);
}

TEST(SeenByEyes, IsNotWhatIsHiddenFromBoth) {
  const Seen seen({eye(-45, 45, ahead), eye(-45, 45, ahead)}, ahead,
                  {right_of(0.5F), right_of(0.25F)});
  ASSERT_NE(seen.part, nullptr);
  // Up to 0.5 of a plane that reaches from -1 to 1, and a point's distance more.
  EXPECT_GT(seen.part->share(), 0.75);
  EXPECT_LT(seen.part->share(), 0.78);
  EXPECT_TRUE(seen.part->contains({0.74F, 0.5F}));
  EXPECT_FALSE(seen.part->contains({0.79F, 0.5F}));
}

TEST(SeenByEyes, IsAllWhereNothingWouldBeSeen) {
  EXPECT_EQ(
      Seen({eye(-45, 45, ahead), eye(-45, 45, ahead)}, ahead, {right_of(-2.0F), right_of(-2.0F)})
          .part,
      nullptr);
}

// Whatever either eye sees lies in it, and little else does.
TEST(SeenByEyes, HoldsWhatEyesSeeThatPointOutwards) {
  const Quat head = head_orientation({.azimuth_rad = 1.0, .elevation_rad = 0.3}, 0.2);
  const auto canted = [&](double azimuth_deg) {
    return head * head_orientation({.azimuth_rad = radians(azimuth_deg)});
  };
  const Seen seen({eye(-50, 40, canted(-10.0)), eye(-40, 50, canted(10.0))}, head,
                  {right_of(0.6F), HiddenTriangles()});
  ASSERT_NE(seen.part, nullptr);
  const Viewport view = viewport_of(head, seen.both);
  Pcg32 random(7);
  int outside = 0;
  constexpr int points = 20'000;
  for (int i = 0; i < points; ++i) {
    const float x = unit_float(random.next());
    const Vec2 place(x, unit_float(random.next()));
    const Vec3 direction = view.direction(place);
    const Vec3 from_left = glm::conjugate(canted(-10.0)) * direction;
    const bool left_sees =
        viewport_of(seen.eyes[0], ahead).project(direction) && from_left.x < -0.6F * from_left.z;
    const bool is_seen =
        left_sees || viewport_of(seen.eyes[1], ahead).project(direction).has_value();
    EXPECT_TRUE(!is_seen || seen.part->contains(place)) << place.x << " " << place.y;
    outside += !is_seen && seen.part->contains(place) ? 1 : 0;
  }
  EXPECT_LT(outside, points / 20);
}

}  // namespace
}  // namespace foveola
