#include "analysis/convergence/pooled_runs.h"

#include <cmath>

#include "analysis/convergence/convergence_files.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/analysis/convergence/made_up_measurement.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

/// One scene with two gazes of three repetitions, some of whose numbers do not exist.
std::vector<GazeMeasurement> all_measurements() {
  std::vector<GazeMeasurement> all(
      2, made_up_measurement({{.name = "od, clamped"}, {.name = "fv", .noise = 0.1}}, 3, 0.3));
  all[1].gaze = "180,0";
  Score& odd = all[1].repetitions[2][1].checkpoints[0].scores[0];
  odd.error.mse = std::nan("");
  odd.flip.reset();
  all[0].predicted[1][0].reset();
  return all;
}

class PooledRunsTest : public testing::Test {
 protected:
  /// As bench convergence writes it.
  std::filesystem::path run(const std::string& name, const std::vector<GazeMeasurement>& measured,
                            nlohmann::ordered_json facts = {}) const {
    facts["plan"].emplace("max_depth", 8);
    facts["date"] = name;
    facts["crops"] = nullptr;
    const ConvergenceTables tables = tabulate(measured);
    for (const TextFile& file : convergence_csv(measured, tables)) {
      folder_.write(name + "/" + file.name, file.content);
    }
    folder_.write(name + "/convergence.json", convergence_json(facts, measured, tables));
    return folder_ / name;
  }

  /// Of each gaze the repetitions from `first` to `last`.
  std::filesystem::path run(const std::string& name, std::ptrdiff_t first,
                            std::ptrdiff_t last) const {
    std::vector<GazeMeasurement> some = all_measurements();
    for (GazeMeasurement& measurement : some) {
      const auto begin = measurement.repetitions.begin();
      measurement.repetitions = {begin + first, begin + last + 1};
    }
    return run(name, some);
  }

  static void expect_refused(const std::vector<std::filesystem::path>& folders,
                             const std::string& says) {
    EXPECT_THAT([&] { (void)pool_runs(folders); }, ThrowsMessage<Error>(HasSubstr(says)));
  }

  test::TemporaryFolder folder_;
};

TEST_F(PooledRunsTest, AreTheWholeToTheLastBit) {
  const std::vector<GazeMeasurement> all = all_measurements();
  const ConvergenceTables tables = tabulate(all);
  const std::vector<TextFile> whole = convergence_csv(all, tables);
  for (const auto& folders : std::vector<std::vector<std::filesystem::path>>{
           {run("whole", all)},
           {run("first", 0, 0), run("others", 1, 2)},
           {run("one gaze", {all[0]}), run("another", {all[1]})}}) {
    const PooledRuns pooled = pool_runs(folders);
    const std::vector<TextFile> files =
        convergence_csv(pooled.measurements, tabulate(pooled.measurements));
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(files[i].content, whole[i].content) << files[i].name << " of " << folders.front();
    }
    EXPECT_EQ(pooled.facts.dump(), R"({"plan":{"max_depth":8}})");
    EXPECT_EQ(pooled.measurements[0].scene_sha256, "aula's");
  }
}

TEST_F(PooledRunsTest, DifferInScenesOrSeedsAlone) {
  const std::filesystem::path first = run("first", 0, 0);
  expect_refused({first, run("again", 0, 1)}, "aula at 10,0 with seed 0, like an earlier run");
  expect_refused({first, run("deeper", all_measurements(), {{"plan", {{"max_depth", 9}}}})},
                 "plan/max_depth is 9, not 8");
  expect_refused({first, run("faster", all_measurements(), {{"processor", "Z80"}})},
                 R"(processor is "Z80", not null)");
  std::vector<GazeMeasurement> others = all_measurements();
  others[0].scene_sha256 = "another's";
  expect_refused({first, run("edited", others)}, "has another scene named aula at 10,0");
  others[0].configurations[1] = "vp";
  expect_refused({first, run("method", others)}, "has other configurations");
}

TEST_F(PooledRunsTest, AreWhole) {
  expect_refused({folder_ / "none"}, "points.csv");
  const std::filesystem::path damaged = run("damaged", 0, 2);
  const std::string points = read_file(damaged / "points.csv");
  for (const std::string& text :
       {points.substr(0, points.size() / 2), points.substr(0, points.rfind("aula")),
        points + "aula,\"10,0\"\r\n"}) {
    write_file(damaged / "points.csv", text);
    expect_refused({damaged}, "damaged: does not contain a complete run");
  }
  write_file(damaged / "convergence.json", "{");
  expect_refused({damaged}, "damaged: does not contain a complete run");
}

}  // namespace
}  // namespace foveola::analysis
