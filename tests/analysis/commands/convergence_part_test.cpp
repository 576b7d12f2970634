#include "analysis/commands/convergence_part.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/convergence/made_up_measurement.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(GazeParts, AreAllRepetitionsInTheirOrder) {
  for (const std::int64_t count : {1, 2, 5, 12, 20}) {
    std::vector<std::tuple<std::size_t, int, std::int64_t>> all;
    for (std::int64_t number = 1; number <= count; ++number) {
      for (const GazePart& part : gaze_parts({number, count}, 2, 2, 3)) {
        EXPECT_GT(part.repetitions.size(), 0);
        for (std::int64_t i = part.repetitions.begin; i < part.repetitions.end; ++i) {
          all.emplace_back(part.scene, part.gaze, i);
        }
      }
    }
    EXPECT_EQ(all.size(), 12U);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    EXPECT_EQ(all.back(), std::tuple(1U, 1, 2));
  }
}

/// One scene with two gazes of three repetitions, whose numbers are made up.
class ConvergencePartTest : public testing::Test {
 protected:
  ConvergencePartTest() {
    run_.scenes = {{.name = "aula", .file = folder_.write("aula.glb", "glTF")}};
    run_.gazes = 2;
    run_.plan.size = {160, 100};
    run_.plan.samples_per_pixel = 16;
    run_.plan.most_repetitions = 3;
    run_.plan.configurations = make_configurations({"od", "fv"}, {});
    const std::vector<std::uint64_t> counts = checkpoints(run_.plan);
    for (const char* gaze : {"0,0", "180,0"}) {
      GazeMeasurement measurement =
          made_up_measurement({{.name = "od"}, {.name = "fv", .noise = 0.1}}, 3, 0.3);
      measurement.gaze = gaze;
      for (Repetition& repetition : measurement.repetitions) {
        for (RenderLog& log : repetition) {
          log.checkpoints.resize(counts.size(), log.checkpoints.back());
          for (std::size_t i = 0; i < counts.size(); ++i) {
            log.checkpoints[i].samples = counts[i];
          }
        }
      }
      measured_.push_back(measurement);
    }
    Score& odd = measured_[1].repetitions[2][1].checkpoints[0].scores[0];
    odd.error.mse = std::nan("");
    odd.flip.reset();
    measured_[0].predicted[1][0].reset();
  }

  std::vector<BenchPart> parts(std::int64_t count) const {
    std::vector<BenchPart> all;
    for (std::int64_t number = 1; number <= count; ++number) {
      std::vector<MeasuredPart> list;
      for (const GazePart& part : gaze_parts({number, count}, 1, 2, 3)) {
        GazeMeasurement some = measured_[static_cast<std::size_t>(part.gaze)];
        const auto first = some.repetitions.begin();
        some.repetitions = {first + part.repetitions.begin, first + part.repetitions.end};
        list.push_back({.scene_key = "aula's", .measurement = some});
      }
      all.push_back(convergence_part(run_, {number, count}, list));
      // As it is read again.
      all.back().results = nlohmann::json::parse(all.back().results.dump());
      all.back().settings = nlohmann::json::parse(all.back().settings.dump());
      all.back().file = "part.json";
    }
    return all;
  }

  test::TemporaryFolder folder_;
  ConvergenceRun run_;
  std::vector<GazeMeasurement> measured_;
};

TEST_F(ConvergencePartTest, AllTogetherAreTheWholeToTheLastBit) {
  const std::vector<TextFile> whole = convergence_csv(measured_, tabulate(measured_));
  for (const std::int64_t count : {1, 2, 4, 6, 9}) {
    const MergedConvergence merged = merged_convergence(parts(count));
    const std::vector<TextFile> files =
        convergence_csv(merged.measurements, tabulate(merged.measurements));
    ASSERT_EQ(files.size(), whole.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
      EXPECT_EQ(files[i].content, whole[i].content) << files[i].name << " of " << count;
    }
    ASSERT_EQ(merged.measurements.size(), 2U);
    EXPECT_EQ(merged.measurements[0].predicted, measured_[0].predicted);
    EXPECT_EQ(merged.plan.size, run_.plan.size);
    EXPECT_EQ(merged.plan.configurations[1].name, "fv");
    EXPECT_EQ(merged.machines.size(), static_cast<std::size_t>(count));
  }
  EXPECT_THAT(merged_convergence(parts(4)).machines[1].repetitions,
              ElementsAre("1 to 2 of aula at 0,0"));
}

TEST_F(ConvergencePartTest, RefusesWhatDoesNotFit) {
  const std::vector<BenchPart> good = parts(2);
  const auto refuses = [&](const std::string& place, const nlohmann::json& value) {
    std::vector<BenchPart> bad = good;
    bad[1].results[nlohmann::json::json_pointer(place)] = value;
    EXPECT_THROW((void)merged_convergence(bad), Error) << place;
  };
  refuses("/measured", nlohmann::json::array());
  refuses("/measured/0/regions", {"5deg", "more"});
  refuses("/measured/0/repetitions", nlohmann::json::array());
  refuses("/measured/0/repetitions/0/1", nullptr);
  refuses("/measured/0/repetitions/0/0/checkpoints/3/samples", 5);
  refuses("/measured/0/repetitions/0/0/checkpoints/3/scores/0/4", -1);
  refuses("/machine/cores", 1e99);
  std::vector<BenchPart> bad = good;
  bad[0].settings["repetitions"] = 0;
  EXPECT_THROW((void)merged_convergence(bad), Error);
}

TEST_F(ConvergencePartTest, RefusesAGazeThatIsOfTwoScenes) {
  std::vector<BenchPart> split = parts(4);
  split[1].results["measured"][0]["scene_key"] = "another's";
  try {
    (void)merged_convergence(split);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("part.json: has measured another scene as aula"));
  }
}

}  // namespace
}  // namespace foveola::analysis
