#include "analysis/convergence/measurement.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "analysis/convergence/convergence_tables.h"
#include "renderer/base/error.h"
#include "tests/renderer/preview/box_room.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

class GazeBenchTest : public testing::Test {
 protected:
  GazeBenchTest() {
    plan_.configurations = make_configurations({"od", "fv"}, {"independent"});
    plan_.size = {64, 32};
    plan_.samples_per_pixel = 16;
    plan_.least_repetitions = 2;
    plan_.most_repetitions = 3;
    plan_.view_size = 40;
    plan_.max_depth = 3;
    plan_.reference_samples_per_pixel = 32;
    plan_.reference_foveated_per_pixel = 8;
    plan_.crop_seconds = 0.01;
    plan_.crop_size = 16;
  }

  GazeBench bench() const {
    return {subject_,
            plan_,
            gaze_,
            workers_,
            folder_ / "references",
            [](const std::string&, double) {},
            stop_.get_token()};
  }

  GazeMeasurement measure(double limit_s = 0.0) const {
    return bench().measure(limit_s, [](const std::string&, double) {});
  }

  test::TemporaryFolder folder_;
  Workers workers_{2};
  LoadedScene loaded_{{.name = "box", .camera_position = Vec3(0.0F)}, box_room(0.5F), workers_};
  Subject subject_{.loaded = loaded_, .key = "box"};
  ConvergencePlan plan_;
  AzimuthElevation gaze_{.azimuth_rad = 0.7};
  std::stop_source stop_;
};

TEST_F(GazeBenchTest, LogsEveryConfigurationAtEveryCheckpoint) {
  const GazeMeasurement measurement = measure();
  EXPECT_EQ(measurement.scene, "box");
  ASSERT_EQ(measurement.repetitions.size(), 3U);
  const std::vector<std::uint64_t> counts = checkpoints(plan_);
  for (const Repetition& repetition : measurement.repetitions) {
    ASSERT_EQ(repetition.size(), 3U);
    for (const RenderLog& log : repetition) {
      EXPECT_EQ(log.dropped, 0U);
      ASSERT_EQ(log.checkpoints.size(), counts.size());
      double before_s = 0.0;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        const Checkpoint& checkpoint = log.checkpoints[i];
        EXPECT_EQ(checkpoint.samples, counts[i]);
        EXPECT_GT(checkpoint.seconds, before_s);
        EXPECT_EQ(checkpoint.scores.size(), measurement.regions.size());
        before_s = checkpoint.seconds;
      }
    }
  }
}

// The scene is as noisy everywhere as makes no matter, so density alone should decide; 20 degrees
// are 45 pixels of this film, whose errors over three repetitions are known to about a sixth.
TEST_F(GazeBenchTest, FindsTheSpeedUpThatDensityPredicts) {
  const GazeMeasurement measurement = measure();
  const ConvergenceTables tables = tabulate({measurement});
  const auto row =
      std::find_if(tables.speed_ups.begin(), tables.speed_ups.end(), [](const SpeedUp& speed_up) {
        return speed_up.configuration == "fv" && speed_up.region == "20deg" &&
               speed_up.metric == Metric::mse;
      });
  ASSERT_NE(row, tables.speed_ups.end());
  ASSERT_TRUE(row->samples_ratio);
  EXPECT_NEAR(row->samples_ratio->value / row->predicted.value_or(0.0), 1.0, 0.35);
}

TEST_F(GazeBenchTest, EachSeedGivesItsOwnRepetitionEveryTime) {
  const GazeMeasurement first = measure();
  const GazeMeasurement second = measure();
  plan_.seed = 2;
  const GazeMeasurement other = measure();
  const auto last_error = [](const GazeMeasurement& measurement, std::size_t repetition) {
    return measurement.repetitions[repetition][0].checkpoints.back().scores.back().error.mse;
  };
  EXPECT_NE(last_error(first, 0), last_error(first, 1));
  EXPECT_EQ(last_error(first, 0), last_error(second, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first.repetitions[i][0].seed, i);
    EXPECT_EQ(other.repetitions[i][0].seed, 2000 + i);
    EXPECT_NE(last_error(other, i), last_error(first, i));
  }
}

TEST_F(GazeBenchTest, MakesItsLeastRepetitionsWhereTimeIsShort) {
  EXPECT_EQ(measure(1e-9).repetitions.size(), 2U);
}

TEST_F(GazeBenchTest, HasNoHalfRepetitionsWhenStopped) {
  const GazeBench ready = bench();
  EXPECT_TRUE(ready
                  .measure(0.0,
                           [this](const std::string&, double fraction) {
                             if (fraction > 0.0) {
                               stop_.request_stop();
                             }
                           })
                  .repetitions.empty());
  EXPECT_NO_THROW((void)bench());  // its reference is cached
  std::filesystem::remove_all(folder_ / "references");
  EXPECT_THROW((void)bench(), Error);
}

TEST_F(GazeBenchTest, PutsCropsSideBySideAndTheReferenceLast) {
  const RgbImage strip = bench().crops();
  EXPECT_EQ(strip.width, 4 * 16 + 3 * 8);
  EXPECT_EQ(strip.height, 16);
  EXPECT_EQ(strip.at(16, 3), Rgb(1.0F));
  for (int y = 0; y < 16; ++y) {
    EXPECT_GT(luminance(strip.at(3 * 24 + 5, y)), 0.0F);
  }
}

// Both halves and all repetitions have noise of their own.
TEST_F(GazeBenchTest, ReferenceHalvesAreIndependent) {
  const ReferenceHalves halves = reference_halves(subject_, plan_, direction_from(gaze_), workers_,
                                                  folder_ / "references", [](double) {}, {});
  EXPECT_NE(halves.first.pixels, halves.second.pixels);
  double sum_first = 0.0;
  double sum_second = 0.0;
  for (std::size_t i = 0; i < halves.first.pixels.size(); ++i) {
    sum_first += halves.first.pixels[i].g;
    sum_second += halves.second.pixels[i].g;
  }
  EXPECT_NEAR(sum_first / sum_second, 1.0, 1e-3);
}

}  // namespace
}  // namespace foveola::analysis
