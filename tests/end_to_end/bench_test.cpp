// The benchmarks as a user runs them: what they print and what they leave behind.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::StartsWith;

class BenchConvergence : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }

  ProgramResult run(std::vector<std::string> options) const {
    std::vector<std::string> arguments = {"bench", "convergence", (folder_ / "room.gltf").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_foveola(arguments, {{"XDG_CACHE_HOME", (folder_ / "cache").string()}});
  }

  std::string results() const { return (folder_ / "results").string(); }

  const TemporaryFolder folder_;
};

TEST_F(BenchConvergence, WritesTablesFiguresAndCrops) {
  const ProgramResult result = run({"-o", results(), "--quick", "--methods", "od,vp", "--options",
                                    "none", "--size", "64x32", "--repetitions", "2", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, read_file(folder_ / "results" / "convergence.json"));
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["measured"][0]["repetitions"], 2);
  EXPECT_EQ(json["measured"][0]["non_finite_samples"], 0);
  EXPECT_EQ(json["costs"].size(), 2U);
  // A view of 100 degrees is a tenth of the image, where VP has all of its samples.
  for (const auto& row : json["overall"]) {
    if (row["region"] == "viewport" && row["metric"] == "mse" && row["configuration"] == "vp") {
      EXPECT_GT(row["samples"]["value"], 3.0);
    }
  }
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "results")) {
    names.push_back(entry.path().filename());
  }
  EXPECT_THAT(names, IsSupersetOf({"points.csv", "speed_ups.csv", "costs.csv", "convergence.csv",
                                   "overall.csv", "convergence.json", "crops-1.png",
                                   "error-1-rmse-viewport.svg", "error-1-flip-viewport.svg"}));
  EXPECT_EQ(image_size(folder_ / "results" / "crops-1.png"), IVec2(3 * 320 + 2 * 8, 320));
}

TEST_F(BenchConvergence, RefusesBadWishesBeforeTheWork) {
  const auto expect_refused = [&](const std::vector<std::string>& options, int exit_code,
                                  const std::string& says) {
    const ProgramResult result = run(options);
    EXPECT_EQ(result.exit_code, exit_code) << says;
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.errors, HasSubstr(says));
    EXPECT_FALSE(fs::exists(folder_ / "results"));
    EXPECT_FALSE(fs::exists(folder_ / "cache"));
  };
  expect_refused({"-o", results(), "--methods", "od,nonsense"}, 1, "nonsense");
  expect_refused({"-o", results(), "--options", "magic"}, 2, "there is no option 'magic'");
  expect_refused({"-o", results(), "--spp", "1"}, 2, "--spp");
  expect_refused({"-o", (folder_ / "no" / "where").string()}, 1, "where");
  expect_refused({"-o", (folder_ / "room.gltf").string()}, 1, "is a file, not a folder");
}

TEST(BenchCompare, PrintsRatiosOfWhatABenchPrinted) {
  const TemporaryFolder folder;
  const std::string before = (folder / "before.json").string();
  write_file(before, run_foveola({"bench", "sampling", "od", "--json"}).output);
  auto later = nlohmann::json::parse(read_file(before));
  for (auto& figure : later["figures"]) {
    for (const char* key : {"median", "low", "high"}) {
      figure[key] = 0.5 * figure[key].get<double>();
    }
  }
  write_file(folder / "after.json", later.dump());
  const ProgramResult result =
      run_foveola({"bench", "compare", before, (folder / "after.json").string(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto ratios = nlohmann::json::parse(result.output).at("ratios");
  ASSERT_EQ(ratios.size(), later["figures"].size());
  for (const auto& ratio : ratios) {
    EXPECT_NEAR(ratio["value"].get<double>(), 0.5, 1e-9);
    EXPECT_LE(ratio["low"].get<double>(), 0.5);
    EXPECT_GE(ratio["high"].get<double>(), 0.5);
  }
  EXPECT_THAT(run_foveola({"bench", "compare", before, before}).output, HasSubstr("1.000"));
  EXPECT_EQ(run_foveola({"bench", "compare", before, (folder / "none.json").string()}).exit_code,
            1);
}

TEST(BenchEquation7, PrintsItsFiguresBesideThePapers) {
  const ProgramResult table = run_foveola({"bench", "equation7"});
  ASSERT_EQ(table.exit_code, 0) << table.errors;
  EXPECT_THAT(table.output, ContainsRegex("what +the program's figure +the paper's\n"));
  EXPECT_THAT(table.output, ContainsRegex("jump at u = 0.0965 +5.7904 deg +-\n"));
  EXPECT_THAT(table.output, ContainsRegex("radius, relative +-0.224 % at u = 0.15.* 1.8 % "));
  const ProgramResult json = run_foveola({"bench", "equation7", "--json"});
  ASSERT_EQ(json.exit_code, 0) << json.errors;
  const auto figures = nlohmann::json::parse(json.output).at("figures");
  for (const auto& figure : figures) {
    if (figure.at("what") == "mean absolute difference over the mean radius") {
      EXPECT_NEAR(figure.at("value").get<double>(), 0.0327, 5e-5);
      EXPECT_EQ(figure.at("unit"), "%");
      EXPECT_THAT(figure.at("published").get<std::string>(), StartsWith("< 0.04 %"));
    }
  }
}

TEST(BenchPreview, TellsWhichFramesAreLate) {
  const ProgramResult result =
      run_foveola({"bench", "preview", "studio-car", "--frames", "20", "--restart-every", "5",
                   "--rate", "20", "--size", "512x256", "--view", "64x64", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json.at("frames"), 20);
  EXPECT_LE(json.at("late_frames"), 20);
  EXPECT_EQ(json.at("starts"), 4);
  EXPECT_EQ(json.at("starts_seen_in_the_first_frame"), 4);
  ASSERT_EQ(json.at("figures").size(), 6U);
  const auto& samples = json.at("figures").at(5);
  EXPECT_GE(samples.at("median"), 64) << "FrameBudget::first_batch, however late it is";
  EXPECT_LE(samples.at("median"), samples.at("percentile_99"));
  EXPECT_GT(json.at("figures").at(2).at("median"), 0.0) << "the view is resampled";
}

}  // namespace
}  // namespace foveola::test
