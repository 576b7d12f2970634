#include "study/prediction/judged_view.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"

namespace foveola::study {
namespace {

Vision vision() {
  return {.view_cell_deg = 0.5, .scale_count = 3.0, .view_patch_deg = 10.0, .looked_at_deg = 2.5};
}

double to_nearest_deg(const std::vector<Vec3>& places, const Vec3& direction) {
  float cosine = -1.0F;
  for (const Vec3& place : places) {
    cosine = std::max(cosine, glm::dot(place, direction));
  }
  return degrees(std::acos(std::min(1.0F, cosine)));
}

// The sphere has 41 253 square degrees.
TEST(SurroundPlaces, LieAPatchApart) {
  const std::vector<Vec3> places = surround_places(vision(), 90.0);
  EXPECT_NEAR(static_cast<double>(places.size()), 412.5, 12.0);
  Pcg32 random(5);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 direction =
        direction_from({.azimuth_rad = radians(360.0 * random.uniform()),
                        .elevation_rad = std::asin(2.0 * random.uniform() - 1.0)});
    ASSERT_LT(to_nearest_deg(places, direction), 10.0);
  }
}

TEST(SurroundPlaces, LieWherePeopleLook) {
  for (const Vec3& place : surround_places(vision(), 40.0)) {
    EXPECT_LE(std::abs(degrees(azimuth_elevation(place).elevation_rad)), 40.0);
  }
}

TEST(SurroundViews, HoldTheCellsInTheMiddleOfEachPlace) {
  const std::vector<Vec3> places = surround_places(vision(), 45.0);
  const DisplaySettings display{.view_width = 640, .view_height = 640};
  const std::vector<JudgedView> views = surround_views(vision(), display, places);
  ASSERT_EQ(views.size(), places.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    ASSERT_EQ(views[i].judged.size(), 3U);
    for (const JudgedCells& judged : views[i].judged) {
      EXPECT_NE(judged.cells.at(places[i]), Cells::none);
      EXPECT_EQ(
          std::count(judged.pixels.pixels_in_cell.begin(), judged.pixels.pixels_in_cell.end(), 0U),
          0)
          << "the view reaches beyond the cells";
    }
  }
}

}  // namespace
}  // namespace foveola::study
