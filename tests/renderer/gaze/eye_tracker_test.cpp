#include "renderer/gaze/eye_tracker.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

const Vec3 ahead(0.0F, 0.0F, -1.0F);

TEST(FixedEyeTracker, AlwaysLooksThere) {
  FixedEyeTracker tracker(ahead);
  const auto sample = tracker.newest(milliseconds(5));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->valid);
  EXPECT_EQ(sample->direction, ahead);
  EXPECT_EQ(sample->time, milliseconds(5));
}

TEST(SimulatedEyeTracker, DeliversNothingBeforeItsLatency) {
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.02},
                              [](Nanoseconds) { return ahead; });
  EXPECT_FALSE(tracker.newest(milliseconds(19)));
  EXPECT_TRUE(tracker.newest(milliseconds(21)));
}

TEST(SimulatedEyeTracker, SamplesTheEyeAtItsRateAndDeliversLate) {
  // The eye turns a degree each millisecond.
  const auto eye = [](Nanoseconds time) {
    return direction_from({.azimuth_rad = radians(seconds(time) * 1000.0)});
  };
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.014, .precision_deg = 0.0}, eye);
  for (const auto& [now_ms, exposed_ms] :
       {std::pair{14, 0}, {23, 0}, {25, 10}, {33, 10}, {47, 30}}) {
    const auto sample = tracker.newest(milliseconds(now_ms) + std::chrono::microseconds(1));
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->time, milliseconds(exposed_ms));
    EXPECT_LT(glm::distance(sample->direction, eye(milliseconds(exposed_ms))), 1e-6F);
  }
}

TEST(SimulatedEyeTracker, NoiseHasItsStandardDeviationOnBothAxes) {
  SimulatedEyeTracker tracker(
      {.rate_hz = 1000.0, .latency_s = 0.0, .precision_deg = 0.5, .seed = 3},
      [](Nanoseconds) { return ahead; });
  constexpr int count = 20000;
  double squares_x = 0.0;
  double squares_y = 0.0;
  double products = 0.0;
  double lagged = 0.0;
  double last_x = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto sample = tracker.newest(milliseconds(i) + std::chrono::microseconds(1));
    const double x = degrees(std::atan(-sample->direction.x / sample->direction.z));
    const double y = degrees(std::atan(-sample->direction.y / sample->direction.z));
    squares_x += x * x;
    squares_y += y * y;
    products += x * y;
    lagged += x * last_x;
    last_x = x;
  }
  EXPECT_NEAR(std::sqrt(squares_x / count), 0.5, 0.02);
  EXPECT_NEAR(std::sqrt(squares_y / count), 0.5, 0.02);
  EXPECT_NEAR(products / count / 0.25, 0.0, 5.0 / std::sqrt(count));
  EXPECT_NEAR(lagged / count / 0.25, 0.0, 5.0 / std::sqrt(count));
}

TEST(SimulatedEyeTracker, NoiseDoesNotDependOnWhenItIsPolled) {
  const SimulatedTrackerSettings settings{.rate_hz = 100.0, .latency_s = 0.01, .seed = 9};
  const auto eye = [](Nanoseconds) { return ahead; };
  SimulatedEyeTracker often(settings, eye);
  SimulatedEyeTracker once(settings, eye);
  for (int now_ms = 0; now_ms < 500; ++now_ms) {
    often.newest(milliseconds(now_ms));
  }
  EXPECT_EQ(often.newest(milliseconds(500))->direction, once.newest(milliseconds(500))->direction);
}

TEST(SimulatedEyeTracker, ABlinkIsAnInvalidSample) {
  SimulatedEyeTracker tracker({.rate_hz = 100.0, .latency_s = 0.0}, [](Nanoseconds time) {
    return time < milliseconds(50) ? std::optional(ahead) : std::nullopt;
  });
  EXPECT_TRUE(tracker.newest(milliseconds(45))->valid);
  EXPECT_FALSE(tracker.newest(milliseconds(65))->valid);
}

}  // namespace
}  // namespace foveola
