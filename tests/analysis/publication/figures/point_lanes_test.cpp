#include <cmath>

#include "analysis/publication/figures/participant_points.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(PointLanes, PointsThatAreFarEnoughApartStayInTheMiddle) {
  EXPECT_THAT(point_lanes({}, 1.0, 3), IsEmpty());
  EXPECT_THAT(point_lanes({4.0, 1.0, 2.0}, 1.0, 3), ElementsAre(0, 0, 0));
}

TEST(PointLanes, EqualPointsLieOnBothSidesOfTheMiddle) {
  EXPECT_THAT(point_lanes({2.0, 2.0, 2.0, 2.0, 2.0}, 1.0, 5), ElementsAre(0, 1, -1, 2, -2));
}

TEST(PointLanes, NoPointHidesAnotherOfItsLane) {
  std::vector<double> positions;
  for (int i = 0; i < 60; ++i) {
    positions.push_back(std::fmod(17.3 * i, 50.0));
  }
  const std::vector<int> lanes = point_lanes(positions, 3.0, 7);
  for (std::size_t a = 0; a < positions.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_TRUE(lanes[a] != lanes[b] || std::abs(positions[a] - positions[b]) >= 3.0)
          << positions[a] << " and " << positions[b];
    }
  }
  EXPECT_EQ(lanes, point_lanes(positions, 3.0, 7));
}

TEST(PointLanes, WhereAllAreTakenAPointGoesWhereItOverlapsLeast) {
  EXPECT_THAT(point_lanes({0.0, 0.2, 0.4, 0.9}, 1.0, 3), ElementsAre(0, 1, -1, 0));
}

}  // namespace
}  // namespace foveola::analysis
