#include "study/participant/ratings.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

constexpr RatingHabits habits{.second_point_jnd = 1.0, .step_factor = 2.0};

TEST(RateArtifacts, GoesUpByAPointAtEachThreshold) {
  const Question scale{.id = "artifacts", .minimum = 1.0, .maximum = 5.0, .simulated = "artifacts"};
  EXPECT_EQ(rate_artifacts(habits, scale, 0.0), 1.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 0.99), 1.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 1.0), 2.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 2.0), 3.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 4.0), 4.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 7.99), 4.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 8.0), 5.0);
  EXPECT_EQ(rate_artifacts(habits, scale, 1e9), 5.0);
}

TEST(RateArtifacts, NeverFallsAsMoreIsNoticed) {
  const Question scale{.id = "artifacts", .minimum = 0.0, .maximum = 7.0, .simulated = "artifacts"};
  double before = 0.0;
  for (double noticed_jnd = 0.0; noticed_jnd < 200.0; noticed_jnd += 0.1) {
    const double rating = rate_artifacts(habits, scale, noticed_jnd);
    EXPECT_GE(rating, before);
    before = rating;
  }
  EXPECT_EQ(before, 7.0);
}

}  // namespace
}  // namespace foveola::study
