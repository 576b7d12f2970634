#include "renderer/trace/lights/surface_regions.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "tests/renderer/trace/random_points.h"

namespace foveola {
namespace {

using test::in_cube;

std::vector<SurfaceRegions::Place> random_places(std::size_t count, float half) {
  std::vector<SurfaceRegions::Place> places;
  Pcg32 random(2);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 position = in_cube(random, half);
    places.push_back({position, glm::normalize(in_cube(random))});
  }
  return places;
}

TEST(SurfaceRegionsTest, EachHoldsAboutAsManyPlaces) {
  const auto places = random_places(10'000, 3.0F);
  const SurfaceRegions regions(places, 100);
  ASSERT_EQ(regions.count(), 64U);
  std::vector<int> held(regions.count(), 0);
  for (const auto& place : places) {
    ASSERT_LT(regions.region_of(place), regions.count());
    ++held[regions.region_of(place)];
  }
  for (const int count : held) {
    EXPECT_GE(count, 156);
    EXPECT_LE(count, 157);
  }
}

TEST(SurfaceRegionsTest, EightPlacesAtOnceAreInTheSameRegions) {
  const SurfaceRegions regions(random_places(5000, 1.0F), 20);
  const auto others = random_places(800, 1.5F);
  for (std::size_t first = 0; first < others.size(); first += lane_count) {
    Vec3Lanes position;
    Vec3Lanes normal;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      position.put(lane, others[first + lane].position);
      normal.put(lane, others[first + lane].normal);
    }
    const Uints found = regions.regions_of(position.load(), normal.load());
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      EXPECT_EQ(found[lane], regions.region_of(others[first + lane]));
    }
  }
}

/// Of a thin wall.
TEST(SurfaceRegionsTest, OppositeSidesAreApart) {
  std::vector<SurfaceRegions::Place> places;
  Pcg32 random(8);
  for (int i = 0; i < 400; ++i) {
    const Vec3 place = in_cube(random);
    const float side = i % 2 == 0 ? 1.0F : -1.0F;
    places.push_back({{place.x, place.y, 0.0F}, {0, 0, side}});
  }
  const SurfaceRegions regions(places, 40);
  for (const auto& place : places) {
    EXPECT_NE(regions.region_of(place), regions.region_of({place.position, -place.normal}));
  }
}

TEST(SurfaceRegionsTest, PlacesThatAreAllTheSameAreNoError) {
  const std::vector<SurfaceRegions::Place> places(1000, {Vec3(1, 2, 3), Vec3(0, 1, 0)});
  const SurfaceRegions regions(places, 10);
  EXPECT_LT(regions.region_of(places[0]), regions.count());
}

TEST(SurfaceRegionsTest, WithoutPlacesThereIsOne) {
  EXPECT_EQ(SurfaceRegions().count(), 1U);
  EXPECT_EQ(SurfaceRegions({}, 10).count(), 1U);
  EXPECT_EQ(SurfaceRegions(random_places(19, 1.0F), 10).count(), 1U);
  EXPECT_EQ(SurfaceRegions().region_of({Vec3(1.0F), Vec3(0, 1, 0)}), 0U);
}

TEST(SurfaceRegionsTest, NumbersThatAreNotFiniteAreInSomeRegion) {
  const SurfaceRegions regions(random_places(1000, 1.0F), 10);
  for (const float x :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_LT(regions.region_of({Vec3(x, -x, 0), Vec3(x)}), regions.count());
  }
}

}  // namespace
}  // namespace foveola
