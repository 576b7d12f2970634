// Benchmarks in parts, which are merged.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

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
