// Benchmarks in parts, which are merged.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/csv.h"
#include "renderer/base/files.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::HasSubstr;

using Options = std::vector<std::string>;

Options operator+(Options options, const Options& others) {
  options.insert(options.end(), others.begin(), others.end());
  return options;
}

class BenchParts : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  ProgramResult bench(const Options& options) const {
    return run_foveola(Options{"bench"} + options, environment_);
  }

  /// Measures all parts of a split, the last one first. Returns their files.
  Options parts(int count, const Options& options, const std::string& name) const {
    Options files;
    for (int number = count; number >= 1; --number) {
      files.push_back(path(fmt::format("{}-{}.json", name, number)));
      const ProgramResult result = bench(
          options + Options{"--shard", fmt::format("{}/{}", number, count), "-o", files.back()});
      EXPECT_EQ(result.exit_code, 0) << result.errors;
      EXPECT_EQ(result.output, fmt::format("{}: part {}/{} of bench {}\n", files.back(), number,
                                           count, options.front()));
    }
    return files;
  }

  ProgramResult merge(const Options& files, const Options& options = {}) const {
    return bench(Options{"merge"} + files + options);
  }

  const TemporaryFolder folder_;
  Environment environment_;
};

/// The last line, the error behind the lines of progress.
std::string error_of(const ProgramResult& result) {
  const std::size_t end = result.errors.find_last_not_of('\n');
  return result.errors.substr(result.errors.rfind('\n', end) + 1);
}

TEST_F(BenchParts, OfStatisticsAreTheWholeByteForByte) {
  const Options options = {"statistics", "--studies",   "4", "--participants", "6", "--seed",
                           "3",          "--resamples", "99"};
  const ProgramResult table = bench(options);
  const ProgramResult json = bench(options + Options{"--json"});
  EXPECT_EQ(table.exit_code, 1) << "of four studies no share is within the required range";
  for (const int count : {1, 3, 6}) {
    SCOPED_TRACE(count);
    const Options files = parts(count, options, "part");
    const ProgramResult merged = merge(files);
    EXPECT_EQ(merged.exit_code, table.exit_code);
    EXPECT_EQ(merged.output, table.output);
    EXPECT_EQ(merged.errors, error_of(table));
    EXPECT_EQ(merge(files, {"--json"}).output, json.output);
  }
}

TEST_F(BenchParts, OfPathsOverScenesAreTheWhole) {
  const Options options = {"stability", "--only", "finite", "--paths", "3000"};
  const auto figures = [](const ProgramResult& result) {
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output).at("figures");
  };
  const nlohmann::json whole = figures(bench(options + Options{"--json"}));
  EXPECT_EQ(figures(merge(parts(2, options, "part"), {"--json"})), whole);
  expect_one_line(bench({"stability", "--only", "leaks", "--shard", "1/2", "-o", path("a.json")}),
                  2, "the other stress tests take minutes and have no parts");
}

TEST_F(BenchParts, AreRefusedIfTheyAreNotThoseOfOneBenchmark) {
  const Options options = {"statistics", "--studies", "2", "--resamples", "99"};
  const Options files = parts(2, options, "part");
  expect_one_line(merge({files[0]}), 1, "bench merge: part 1/2 is missing");
  expect_one_line(merge({files[0], files[1], files[0]}), 1, "part 2/2 is there more than once");
  const Options others = parts(2, options + Options{"--seed", "2"}, "other");
  expect_one_line(merge({files[0], others[1]}), 1, "seed is 2, not 1");
  const std::string text = read_file(files[1]);
  write_file(files[1], replaced(text, "\"studies\":1", "\"studies\":2"));
  expect_one_line(merge(files), 1, "part-1.json: is damaged");
  write_file(files[1], replaced(text, "Foveola ", "Foveola 9"));
  expect_one_line(merge(files), 1, "part-1.json: was measured by Foveola 9");
  write_file(files[1], "{}");
  expect_one_line(merge(files), 1, "part-1.json: is no part of a benchmark");
}

/// A table without the columns whose names have one of `words` in them.
std::vector<CsvRow> without(const fs::path& file, const std::vector<std::string>& words) {
  std::vector<CsvRow> rows = parse_csv(read_file(file), file.string());
  const CsvRow names = rows.front();
  for (CsvRow& row : rows) {
    CsvRow kept;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::none_of(words, [&](const std::string& word) {
            return names[i].find(word) != std::string::npos;
          })) {
        kept.push_back(row[i]);
      }
    }
    row = std::move(kept);
  }
  return rows;
}

Options replaced_last(Options options, const std::string& last) {
  options.back() = last;
  return options;
}

class BenchConvergenceParts : public BenchParts {
 protected:
  BenchConvergenceParts() {
    write_file(folder_ / "room.gltf", room_gltf());
    environment_ = {{"XDG_CACHE_HOME", path("cache")}};
  }

  /// Two gazes with three repetitions each: six items.
  Options options() const {
    return {"convergence", path("room.gltf"), "--gazes", "2",         "--repetitions",
            "3",           "--methods",       "od,vp",   "--options", "none",
            "--size",      "32x16",           "--spp",   "16",        "--view-size",
            "32",          "--max-depth",     "3"};
  }

  /// References, each of which has a file with its digest beside it.
  std::ptrdiff_t cached() const {
    const auto is_reference = [](const fs::directory_entry& entry) {
      return entry.path().extension() == ".exr";
    };
    return std::ranges::count_if(
        fs::directory_iterator(folder_ / "cache" / "foveola" / "references"), is_reference);
  }
};

TEST_F(BenchConvergenceParts, HaveTheErrorsOfTheWhole) {
  const ProgramResult whole = bench(options() + Options{"-o", path("whole")});
  ASSERT_EQ(whole.exit_code, 0) << whole.errors;
  for (const int count : {4, 8}) {
    SCOPED_TRACE(count);
    const std::string folder = fmt::format("merged-{}", count);
    const ProgramResult merged =
        merge(parts(count, options(), "part"), {"-o", path(folder), "--json"});
    ASSERT_EQ(merged.exit_code, 0) << merged.errors;
    // Whatever has no seconds in it.
    for (const auto& [table, timed] : std::vector<std::pair<std::string, Options>>{
             {"points.csv", {"seconds"}},
             {"speed_ups.csv", {"time"}},
             {"overall.csv", {"time"}},
             {"convergence.csv", {"time", "efficiency"}}}) {
      EXPECT_EQ(without(folder_ / folder / table, timed), without(folder_ / "whole" / table, timed))
          << table;
    }
    EXPECT_EQ(merged.output, read_file(folder_ / folder / "convergence.json"));
    const auto json = nlohmann::json::parse(merged.output);
    ASSERT_EQ(json["machines"].size(), static_cast<std::size_t>(count));
    EXPECT_GE(json["machines"][0]["cores"], 1);
    EXPECT_THAT(json["times"].get<std::string>(), HasSubstr("where machines are alike"));
    EXPECT_TRUE(json["crops"].is_null());
    EXPECT_EQ(json["plan"],
              nlohmann::json::parse(read_file(folder_ / "whole" / "convergence.json"))["plan"]);
    EXPECT_TRUE(fs::exists(folder_ / folder / "error-2-rmse-sphere.svg"));
    EXPECT_FALSE(fs::exists(folder_ / folder / "crops-1.png"));
  }
}

TEST_F(BenchConvergenceParts, RenderOnlyTheReferencesThatTheyNeed) {
  const ProgramResult first = bench(options() + Options{"--shard", "1/6", "-o", path("1.json")});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(cached(), 2) << "both halves of one gaze";
  const ProgramResult third = bench(options() + Options{"--references", "--shard", "3/4"});
  ASSERT_EQ(third.exit_code, 0) << third.errors;
  EXPECT_THAT(third.output, HasSubstr("1 half of a reference"));
  EXPECT_EQ(cached(), 3);
  EXPECT_EQ(bench(options() + Options{"--references"}).exit_code, 0);
  EXPECT_EQ(cached(), 4);
  const ProgramResult last = bench(options() + Options{"--shard", "6/6", "-o", path("6.json")});
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  EXPECT_EQ(cached(), 4) << "nothing was rendered again under another name";
}

TEST_F(BenchConvergenceParts, AreRefusedIfTheyDoNotFitTogether) {
  const Options files = parts(2, options(), "part");
  expect_one_line(merge(files), 2, "--output: is required");
  expect_one_line(merge({files[0]}, {"-o", path("m")}), 1, "part 1/2 is missing");
  const Options deeper = parts(2, replaced_last(options(), "2"), "deeper");
  expect_one_line(merge({files[0], deeper[1]}, {"-o", path("m")}), 1, "max_depth is 2, not 3");
  write_file(folder_ / "room.gltf", read_file(folder_ / "room.gltf") + "\n");
  const Options later = parts(2, options(), "later");
  expect_one_line(merge({files[0], later[1]}, {"-o", path("m")}), 1, "sha256 of scene 1 is");
  write_file(files[0], replaced(read_file(files[0]), "\"samples\":512", "\"samples\":513"));
  expect_one_line(merge(files, {"-o", path("m")}), 1, "part-2.json: is damaged");
  EXPECT_FALSE(fs::exists(path("m")));
  expect_one_line(bench(options() + Options{"--quick", "--shard", "1/2", "-o", path("a.json")}), 2,
                  "--shard: does not go with --quick");
  expect_one_line(bench(options()), 2, "--output: is required");
}

TEST_F(BenchParts, RefuseBadWishesBeforeTheWork) {
  expect_one_line(bench({"statistics", "--shard", "3/2", "-o", path("a.json")}), 2, "--shard");
  expect_one_line(bench({"statistics", "--shard", "1/2", "-o", path("no/where.json")}), 1, "where");
  expect_one_line(bench({"statistics", "--shard", "1/2"}), 2, "--output");
  expect_one_line(bench({"statistics", "-o", path("a.json")}), 2, "--shard");
  expect_one_line(bench({"merge"}), 2, "PART");
  EXPECT_FALSE(fs::exists(path("a.json")));
}

}  // namespace
}  // namespace foveola::test
