#include "renderer/view/equirect.h"

#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/viewport.h"

namespace foveola {
namespace {

void expect_near(const Vec2& a, const Vec2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6F);
  EXPECT_NEAR(a.y, b.y, 1e-6F);
}

TEST(Equirect, FollowsTheConvention) {
  expect_near(equirect_from_direction({0, 0, -1}), {0.5F, 0.5F});
  expect_near(equirect_from_direction({1, 0, 0}), {0.75F, 0.5F});
  expect_near(equirect_from_direction({-1, 0, 0}), {0.25F, 0.5F});
  EXPECT_NEAR(equirect_from_direction({0, 1, 0}).y, 0.0F, 1e-6F);
  EXPECT_NEAR(equirect_from_direction({0, -1, 0}).y, 1.0F, 1e-6F);
  EXPECT_LT(glm::distance(direction_from_equirect({0.75F, 0.25F}), glm::normalize(Vec3(1, 1, 0))),
            1e-6F);
}

TEST(Equirect, StaysBelowOneAtTheSeam) {
  for (const float x : {0.0F, -0.0F, 1e-30F, -1e-30F, 1e-7F, -1e-7F}) {
    const float u = equirect_from_direction({x, 0.0F, 1.0F}).x;
    EXPECT_GE(u, 0.0F);
    EXPECT_LT(u, 1.0F);
  }
}

TEST(Equirect, RoundTripsEverywhere) {
  Pcg32 generator(1);
  for (int i = 0; i < 100'000; ++i) {
    const double x = generator.normal();
    const double y = generator.normal() * (i % 3 == 0 ? 1000.0 : 1.0);  // many near the poles
    const double z = generator.normal();
    const Vec3 direction = glm::normalize(Vec3(x, y, z));
    const Vec3 back = direction_from_equirect(equirect_from_direction(direction));
    ASSERT_LT(glm::distance(back, direction), 5e-7F);  // 2^-24 turns are 3.7e-7 radians
  }
}

// The last bit of a position near 1 is 2^-24. Near the poles a step of u is short.
TEST(Equirect, ReturnsToTheSamePlaceButForTheLastBit) {
  Pcg32 generator(2);
  for (int i = 0; i < 200'000; ++i) {
    float u = unit_float(generator.next());
    float v = unit_float(generator.next());
    if (i % 4 == 1) {
      u = std::fmod(1.0F + (u - 0.5F) * 1e-4F, 1.0F);  // at the seam
    } else if (i % 4 == 2) {
      v *= 1e-3F;
    } else if (i % 4 == 3) {
      v = 1.0F - 1e-3F * v;
    }
    const Vec2 back = equirect_from_direction(direction_from_equirect({u, v}));
    const double apart = std::abs(static_cast<double>(back.x) - u);
    const double along = std::min(apart, 1.0 - apart) * std::sin(std::numbers::pi * v);
    ASSERT_LE(along, 0x1p-24) << u << ", " << v;
    ASSERT_LE(std::abs(static_cast<double>(back.y) - v), 0x1p-24) << u << ", " << v;
  }
}

// Every pixel of a panorama of radiance 1 by its solid angle. The midpoint rule makes of the
// cosine's integral, 2, the sum (pi / h) / sin(pi / 2h) over h rows.
TEST(Equirect, AConstantPanoramaHasTheEnergyOfTheSphere) {
  constexpr int width = 64;
  constexpr int height = 32;
  double energy_sr = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 centre((static_cast<float>(x) + 0.5F) / width,
                        (static_cast<float>(y) + 0.5F) / height);
      energy_sr += 1.0 / (width * height * equirect_area_per_sr(direction_from_equirect(centre)));
    }
  }
  const double row = std::numbers::pi / height;
  const double expected = 2.0 * std::numbers::pi * row / std::sin(0.5 * row);
  EXPECT_NEAR(energy_sr, expected, 1e-7 * expected);
}

TEST(Equirect, WrapsAcrossTheSeam) {
  const Vec3 inside = direction_from_equirect({0.25F, 0.4F});
  EXPECT_LT(glm::distance(direction_from_equirect({1.25F, 0.4F}), inside), 1e-6F);
  EXPECT_LT(glm::distance(direction_from_equirect({-0.75F, 0.4F}), inside), 1e-6F);
}

// The rounded pi lies beyond the pole, where the image would be upside down.
TEST(Equirect, TheLastRowEndsAtThePole) {
  EXPECT_EQ(direction_from_equirect({0.75F, 1.0F}), Vec3(0.0F, -1.0F, 0.0F));
  EXPECT_EQ(direction_from_equirect({0.75F, 0.0F}), Vec3(0.0F, 1.0F, 0.0F));
}

TEST(Equirect, AreaPerSteradianIsTheJacobian) {
  for (const double elevation_deg : {0.0, 45.0, -80.0}) {
    const double e = radians(elevation_deg);
    const double expected = 1.0 / (2.0 * std::numbers::pi * std::numbers::pi * std::cos(e));
    EXPECT_NEAR(equirect_area_per_sr(direction_from({.elevation_rad = e})), expected,
                1e-5 * expected);
  }
}

TEST(Viewport, CornersAndCentre) {
  const Viewport view(head_orientation({}), radians(90.0), radians(90.0));
  EXPECT_LT(glm::distance(view.direction({0.5F, 0.5F}), Vec3(0, 0, -1)), 1e-6F);
  EXPECT_LT(glm::distance(view.direction({0.0F, 0.0F}), glm::normalize(Vec3(-1, 1, -1))), 1e-6F);
  EXPECT_LT(glm::distance(view.direction({1.0F, 1.0F}), glm::normalize(Vec3(1, -1, -1))), 1e-6F);
}

TEST(Viewport, ProjectsWhatItShowsAndNothingElse) {
  const AzimuthElevation heading{.azimuth_rad = radians(170.0), .elevation_rad = radians(-40.0)};
  const Viewport view(head_orientation(heading), radians(100.0), radians(60.0));
  EXPECT_LT(glm::distance(view.direction({0.5F, 0.5F}), direction_from(heading)), 1e-6F);
  for (const Vec2 plane : {Vec2(0.1F, 0.2F), Vec2(0.9F, 0.5F), Vec2(0.5F, 0.99F)}) {
    const auto back = view.project(view.direction(plane));
    ASSERT_TRUE(back);
    EXPECT_LT(glm::distance(*back, plane), 1e-6F);
  }
  EXPECT_FALSE(view.project(-direction_from(heading)));
  EXPECT_FALSE(view.project(view.direction({1.1F, 0.5F})));
}

TEST(Viewport, TheHorizonStaysLevel) {
  const Quat head = head_orientation({.azimuth_rad = 1.0, .elevation_rad = 0.7});
  EXPECT_NEAR((head * Vec3(1, 0, 0)).y, 0.0F, 1e-6F);
}

/// Steradians of the whole view: midpoints of sr_per_area(), within 1e-6.
double solid_angle_sr(const Viewport& view) {
  constexpr int cells = 1024;
  double sum = 0.0;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      sum += view.sr_per_area((Vec2(x, y) + 0.5F) / static_cast<float>(cells));
    }
  }
  return sum / (cells * cells);
}

// Six square views of 90 degrees make a sphere.
TEST(Viewport, SolidAngleOfACubeFaceIsASixthOfTheSphere) {
  const Viewport view(head_orientation({}), radians(90.0), radians(90.0));
  EXPECT_NEAR(solid_angle_sr(view), 4.0 * std::numbers::pi / 6.0, 1e-6);
}

/// A headset's left eye: its axis nearer the nose, its picture stretched towards the edge.
const Viewport left_eye(head_orientation({.azimuth_rad = 2.0, .elevation_rad = 0.4}), radians(90.0),
                        radians(100.0), {.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F});

TEST(Viewport, ALensIsUndoneByProject) {
  for (const RadialLens& lens : {left_eye.lens(), mirrored(left_eye.lens()),
                                 RadialLens{.k1 = -0.1F}, RadialLens{.k1 = 0.1F, .k2 = -0.01F}}) {
    const Viewport view(left_eye.head(), radians(90.0), radians(100.0), lens);
    for (const Vec2 plane : {Vec2(0.0F), Vec2(0.56F, 0.5F), Vec2(0.3F, 0.9F), Vec2(1.0F, 0.02F)}) {
      const auto back = view.project(view.direction(plane) * 3.0F);
      // The corner may round to the outside.
      if (back) {
        EXPECT_LT(glm::distance(*back, plane), 2e-6F);
      } else {
        EXPECT_EQ(plane, Vec2(0.0F));
      }
    }
  }
  EXPECT_FALSE(left_eye.project(left_eye.direction({1.05F, 0.5F})));
  EXPECT_FALSE(left_eye.project(-left_eye.direction({0.5F, 0.5F})));
}

// Brown's formula, written out: on the axis' height, a quarter of the display from the axis.
TEST(Viewport, ALensBendsByItsProfile) {
  const double d = 2.0 * 0.25 * std::tan(radians(45.0));
  const double seen = d * (1.0 + 0.22 * d * d + 0.24 * d * d * d * d);
  const Vec3 axis = left_eye.direction(left_eye.lens().axis);
  EXPECT_NEAR(angle_between(axis, left_eye.direction({0.31F, 0.5F})), std::atan(seen), 1e-6);
}

// The area of triangles between neighbouring directions against the stated one.
TEST(Viewport, SolidAnglePerAreaIsThatOfSmallPatches) {
  const float h = 1e-3F;
  for (const Vec2 plane : {Vec2(0.56F, 0.5F), Vec2(0.1F, 0.8F), Vec2(0.95F, 0.05F)}) {
    const DVec3 across(left_eye.direction(plane + Vec2(h, 0)) -
                       left_eye.direction(plane - Vec2(h, 0)));
    const DVec3 down(left_eye.direction(plane + Vec2(0, h)) -
                     left_eye.direction(plane - Vec2(0, h)));
    const double expected = glm::length(glm::cross(across, down)) / (4.0 * h * h);
    EXPECT_NEAR(left_eye.sr_per_area(plane), expected, 1e-3 * expected);
  }
}

TEST(Viewport, SolidAngleThroughALensIsThatOfTheDirectionsThatItShows) {
  constexpr int count = 200'000;
  int shown = 0;
  for (int i = 0; i < count; ++i) {  // spherical Fibonacci points
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const Vec3 direction =
        direction_from({.azimuth_rad = 2.0 * std::numbers::pi * i / std::numbers::phi,
                        .elevation_rad = std::asin(y)});
    shown += left_eye.project(direction) ? 1 : 0;
  }
  const double expected = 4.0 * std::numbers::pi * shown / count;
  EXPECT_NEAR(solid_angle_sr(left_eye), expected, 2e-3 * expected);
}

TEST(Viewport, ALensThatFoldsTheDisplayIsRefused) {
  EXPECT_THROW(Viewport(head_orientation({}), 1.5, 1.5, {.k1 = -0.9F}), Error);
  EXPECT_THROW(Viewport(head_orientation({}), 1.5, 1.5, {.k1 = std::nanf("")}), Error);
}

TEST(Viewport, RefusesWhatCannotBeShownFlat) {
  for (const double fov_deg : {0.0, -10.0, 180.0, 200.0, std::nan("")}) {
    EXPECT_THROW(Viewport(head_orientation({}), radians(fov_deg), 1.0), Error);
    EXPECT_THROW(Viewport(head_orientation({}), 1.0, radians(fov_deg)), Error);
  }
}

}  // namespace
}  // namespace foveola
