#include "study/simulation/gaze_validation.h"

#include <cmath>
#include <numbers>

#include "study/participant/simulated_participant.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

Protocol protocol_with(const SimulatedTrackerSettings& tracker, bool correct) {
  Protocol protocol;
  protocol.tracker.simulated = tracker;
  protocol.tracker.validation = ValidationSettings{
      .points = 5,
      .gate = {.max_accuracy_deg = 0.5, .max_precision_deg = 0.3, .max_data_loss = 0.1},
      .correct = correct};
  return protocol;
}

class GazeValidation : public testing::Test {
 protected:
  std::optional<GazeValidated> validate(const SimulatedTrackerSettings& tracker,
                                        bool correct = false) {
    return validate_gaze(protocol_with(tracker, correct), participant_, 17, clock_,
                         stop_.get_token());
  }

  SimulatedParticipant participant_{Population{}, [](const std::string&) { return KnownScene{}; },
                                    3};
  VirtualClock clock_;
  std::stop_source stop_;
};

// Of noise alone: s sqrt(pi / 2), and 2 s between samples.
TEST_F(GazeValidation, PassesATrackerThatOnlyHasNoise) {
  const auto validated = validate({.precision_deg = 0.1});
  ASSERT_TRUE(validated);
  EXPECT_TRUE(validated->passed);
  ASSERT_EQ(validated->runs.size(), 1U);
  const GazeRun& run = validated->runs[0];
  EXPECT_TRUE(run.passed);
  EXPECT_FALSE(run.correction);
  EXPECT_FALSE(correction_after(*validated));
  ASSERT_EQ(run.quality.targets.size(), 5U);
  EXPECT_NEAR(run.quality.figures->accuracy_deg, 0.1 * std::sqrt(0.5 * std::numbers::pi), 0.01);
  EXPECT_NEAR(run.quality.figures->precision_rms_deg, 0.2, 0.01);
  EXPECT_LT(run.quality.data_loss, 0.01);
  EXPECT_GT(clock_.now(), 5 * std::chrono::milliseconds(1700)) << "a second each, once settled";
}

TEST_F(GazeValidation, ACorrectionMakesABiasedTrackerPass) {
  const auto validated =
      validate({.precision_deg = 0.1, .bias_right_deg = 2.0, .bias_up_deg = -1.0}, true);
  ASSERT_TRUE(validated);
  EXPECT_TRUE(validated->passed);
  ASSERT_EQ(validated->runs.size(), 2U);
  EXPECT_FALSE(validated->runs[0].passed);
  EXPECT_FALSE(validated->runs[0].correction);
  EXPECT_TRUE(validated->runs[1].passed);
  EXPECT_LT(validated->runs[1].quality.figures->accuracy_deg, 0.15);
  const auto correction = correction_after(*validated);
  ASSERT_TRUE(correction);
  EXPECT_NEAR(correction->azimuth.x, -2.0, 0.05);
  EXPECT_NEAR(correction->elevation.x, 1.0, 0.05);
}

TEST_F(GazeValidation, CanBeStopped) {
  stop_.request_stop();
  EXPECT_FALSE(validate({}));
}

}  // namespace
}  // namespace foveola::study
