#include "analysis/convergence/error_curve.h"

#include "tests/analysis/convergence/made_up_measurement.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

constexpr std::array<std::size_t, 2> both = {0, 1};

ErrorCurve power_law(double factor, double exponent) {
  ErrorCurve curve;
  for (double samples = 100.0; samples <= 6400.0; samples *= 2.0) {
    curve.push_back({.samples = samples,
                     .seconds = samples / 50.0,
                     .error = factor * std::pow(samples, exponent)});
  }
  return curve;
}

TEST(MeanCurve, AveragesTheRepetitions) {
  const GazeMeasurement measurement =
      made_up_measurement({{.name = "od", .noise = 8.0, .cost_s = 0.5}}, 2, 0.5);
  const ErrorCurve curve = mean_curve(measurement, {}, both);
  // 1000 samples are only one a pixel.
  ASSERT_EQ(curve.size(), 6U);
  EXPECT_EQ(curve.front().samples, 2000.0);
  EXPECT_EQ(curve.front().seconds, 1000.0);
  EXPECT_DOUBLE_EQ(curve.front().error, 1.25 * 8.0 / 2000.0);
  const ErrorCurve flip = mean_curve(measurement, {.metric = Metric::flip}, std::array{both[0]});
  EXPECT_DOUBLE_EQ(flip.back().error, std::sqrt(8.0 / 64000.0));
  const ErrorCurve relative = mean_curve(measurement, {.metric = Metric::relative_mse}, both);
  EXPECT_DOUBLE_EQ(relative.back().error, 2.0 * curve.back().error);
}

TEST(MeanCurve, LeavesOutWhatCannotBeCompared) {
  GazeMeasurement measurement = made_up_measurement({{.name = "od", .per_pixel = 1.0}}, 1);
  std::vector<Checkpoint>& checkpoints = measurement.repetitions[0][0].checkpoints;
  checkpoints[0].scores[0].error.empty_share = 0.5;
  checkpoints[1].scores[0].error.mse = -1e-9;
  checkpoints[2].scores[0].error.mse = std::nan("");
  checkpoints[3].scores[0].error.samples_per_pixel = 1.5;
  checkpoints[4].scores[0].flip.reset();
  EXPECT_EQ(mean_curve(measurement, {}, std::array{both[0]}).size(), 3U);
  EXPECT_EQ(mean_curve(measurement, {.metric = Metric::flip}, std::array{both[0]}).size(), 4U);
}

TEST(Reach, IsExactForAPowerLaw) {
  const ErrorCurve curve = power_law(5.0, -1.0);
  EXPECT_NEAR(reach(curve, 5.0 / 777.0, Axis::samples).value_or(0.0), 777.0, 1e-9);
  EXPECT_NEAR(reach(curve, 5.0 / 777.0, Axis::seconds).value_or(0.0), 777.0 / 50.0, 1e-9);
  EXPECT_NEAR(reach(curve, curve.back().error, Axis::samples).value_or(0.0), 6400.0, 1e-9);
  EXPECT_NEAR(reach(curve, curve.front().error, Axis::samples).value_or(0.0), 100.0, 1e-9);
}

TEST(Reach, ExtrapolatesNothingBeyondTheCurve) {
  const ErrorCurve curve = power_law(5.0, -1.0);
  EXPECT_FALSE(reach(curve, 5.0 / 99.0, Axis::samples));
  EXPECT_FALSE(reach(curve, 5.0 / 6401.0, Axis::samples));
  EXPECT_FALSE(reach({}, 1.0, Axis::samples));
}

TEST(LogLogSlope, IsTheExponentOfAPowerLaw) {
  EXPECT_NEAR(log_log_slope(power_law(3.0, -1.25), Axis::samples).value_or(0.0), -1.25, 1e-12);
  EXPECT_NEAR(log_log_slope(power_law(3.0, -1.25), Axis::seconds).value_or(0.0), -1.25, 1e-12);
  ErrorCurve two = power_law(3.0, -1.0);
  two.resize(2);
  EXPECT_FALSE(log_log_slope(two, Axis::samples));
}

// Least squares by hand over x = 0, 1, 2 (in units of ln 2) and y = 0, -1, -4: -2.
TEST(LogLogSlope, IsLeastSquares) {
  const ErrorCurve curve = {{.samples = 1.0, .error = 1.0},
                            {.samples = 2.0, .error = 0.5},
                            {.samples = 4.0, .error = 0.0625}};
  EXPECT_NEAR(log_log_slope(curve, Axis::samples).value_or(0.0), -2.0, 1e-12);
}

}  // namespace
}  // namespace foveola::analysis
