#include <gtest/gtest.h>

#include "study/participant/answers.h"

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

}  // namespace
}  // namespace foveola::study
