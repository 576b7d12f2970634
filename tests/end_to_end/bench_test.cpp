// The benchmarks as a user runs them: what they print and what they leave behind.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class BenchConvergence : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }

  ProgramResult run(const std::vector<std::string>& options) const {
    return run_foveola(joined({"bench", "convergence", (folder_ / "room.gltf").string()}, options),
                       {{"XDG_CACHE_HOME", (folder_ / "cache").string()}});
  }

  std::string results() const { return (folder_ / "results").string(); }

  const TemporaryFolder folder_;
};

TEST_F(BenchConvergence, WritesTablesFiguresAndCrops) {
  const ProgramResult result =
      succeeded(run({"-o", results(), "--quick", "--methods", "od,vp", "--options", "none",
                     "--size", "64x32", "--repetitions", "2", "--json"}));
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
  expect_refused({"-o", results(), "--options", "magic"}, 2, "'magic' is not an option");
  expect_refused({"-o", results(), "--spp", "1"}, 2, "--spp");
  expect_refused({"-o", (folder_ / "no" / "where").string()}, 1, "where");
  expect_refused({"-o", (folder_ / "room.gltf").string()}, 1, "is read by the command, too");
}

// Seeds are pooled by their counts, as docs/CLUSTER.md shows.
TEST(BenchStatistics, CountsStudiesAndHits) {
  const ProgramResult result =
      run_foveola({"bench", "statistics", "--studies", "3", "--resamples", "99", "--json"});
  EXPECT_EQ(result.exit_code, 1) << "of three studies no share is within the required range";
  for (const auto& figure : nlohmann::json::parse(result.output).at("figures")) {
    if (figure.at("studies") > 0) {
      EXPECT_NEAR(figure.at("percent").get<double>() * figure.at("studies").get<double>(),
                  100.0 * figure.at("hits").get<double>(), 1e-9)
          << figure.at("name");
    }
  }
}

TEST(BenchCompare, ComparesWhatABenchPrinted) {
  const TemporaryFolder folder;
  const std::string before = (folder / "before.json").string();
  write_file(before, run_foveola({"bench", "sampling", "od", "--json"}).output);
  const std::string same = run_foveola({"bench", "compare", before, before}).output;
  EXPECT_THAT(same, HasSubstr("Moved: 0 of 7 figures with intervals"));
  EXPECT_THAT(same, HasSubstr("Stayed: 7 of 7 figures\n"));
  const auto json = nlohmann::json::parse(read_file(before));
  EXPECT_FALSE(json.at("processor").get<std::string>().empty());
  EXPECT_GT(json.at("memory_gb"), 0.0);
  EXPECT_EQ(json.at("date").get<std::string>().size(), 10U);
}

TEST(BenchPreview, TellsWhichFramesAreLate) {
  const ProgramResult result = succeeded(
      run_foveola({"bench", "preview", "studio-car", "--frames", "20", "--restart-every", "5",
                   "--rate", "20", "--size", "512x256", "--view", "64x64", "--json"}));
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

// 2^23 samples over Reddy's 1091.85 square degrees (the paper's normaliser) in the fovea.
TEST(BenchSampling, CountsWhereSamplesFall) {
  const ProgramResult result =
      succeeded(run_foveola({"bench", "sampling", "--density", "fv", "--json"}));
  const nlohmann::json rings = nlohmann::json::parse(result.output).at("rings");
  const nlohmann::json& ring = rings.at(1);
  EXPECT_EQ(ring.at("to_deg"), 1.0);
  EXPECT_NEAR(ring.at("samples_per_square_degree").get<double>(), 8388608.0 / 1091.85, 76.0);
  EXPECT_NEAR(ring.at("stated_per_square_degree").get<double>(), 8388608.0 / 1091.85, 2.0);
}

TEST(Bench, TracingIsMeasuredAgainstEmbreeAlone) {
  const ProgramResult result = succeeded(
      run_foveola({"bench", "tracing", "studio-car", "--paths", "20000", "--repetitions", "6",
                   "--threads", "1,2", "--size", "256x128", "--no-fast-path", "--json"}));
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["runs"].size(), 2U);
  // One by one, and in packets of both kinds; Embree 3 has streams, of both kinds, too.
  const auto ray_tracer = json["ray_tracer"].get<std::string>();
  const std::size_t entry_points = ray_tracer.starts_with("Embree 3.") ? 5 : 3;
  for (const auto& run : json["runs"]) {
    EXPECT_GT(run["general_path"]["gain"]["median"], 0.0);
    EXPECT_EQ(run["rays"], json["runs"][0]["rays"]);
    EXPECT_GE(run["rays"]["primary"], 20000);
    EXPECT_GT(run["rays_per_second"]["shadow"]["low"], 0.0);
    for (const char* figure :
         {"seconds", "paths_per_second", "embree_seconds", "ratio_to_embree"}) {
      const auto& median = run[figure];
      EXPECT_GT(median["low"], 0.0) << figure;
      EXPECT_LE(median["low"], median["median"]) << figure;
      EXPECT_LE(median["median"], median["high"]) << figure;
    }
    for (const char* kind : {"primary", "bounce", "shadow"}) {
      EXPECT_EQ(run["embree"][kind]["seconds"].size(), entry_points) << kind;
      EXPECT_TRUE(run["embree"][kind]["seconds"].contains(run["embree"][kind]["fastest"])) << kind;
    }
  }
}

}  // namespace
}  // namespace foveola::test
