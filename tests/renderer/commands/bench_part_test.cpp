#include "renderer/commands/bench_part.h"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::HasSubstr;

BenchPart part_of_three(std::int64_t number) {
  return {.command = "statistics",
          .shard = {number, 3},
          .settings = {{"seed", 1}, {"scene", "aula \xff"}},
          .results = {{"sum", 0.1 * static_cast<double>(number)}, {"least", -0.0}},
          .file = {}};
}

class BenchPartTest : public ::testing::Test {
 protected:
  BenchPartTest() {
    for (std::int64_t number = 1; number <= 3; ++number) {
      files_.push_back(write(part_of_three(number), "part-" + std::to_string(number) + ".json"));
    }
  }

  fs::path write(const BenchPart& part, const std::string& name) {
    write_bench_part(folder_ / name, part);
    return folder_ / name;
  }

  /// The second part's file with `to` where it has `from`.
  void edit(const std::string& from, const std::string& to) {
    std::string text = read_file(files_[1]);
    text.replace(text.find(from), from.size(), to);
    write_file(files_[1], text);
  }

  void expect_refused(const std::string& what) {
    try {
      (void)read_whole_bench(files_);
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(what));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }

  test::TemporaryFolder folder_;
  std::vector<fs::path> files_;
};

TEST_F(BenchPartTest, AllPartsInAnyOrderAreTheWhole) {
  std::ranges::reverse(files_);
  const std::vector<BenchPart> parts = read_whole_bench(files_);
  ASSERT_EQ(parts.size(), 3U);
  for (std::int64_t i = 0; i < 3; ++i) {
    const BenchPart& part = parts[static_cast<std::size_t>(i)];
    EXPECT_EQ(part.command, "statistics");
    EXPECT_EQ(part.shard, (Shard{i + 1, 3}));
    EXPECT_EQ(part.settings.at("seed"), 1);
    EXPECT_EQ(part.results, part_of_three(i + 1).results) << "numbers are exact";
    EXPECT_TRUE(std::signbit(part.results.at("least").get<double>()));
  }
}

TEST_F(BenchPartTest, RefusesPartsThatAreMissingOrThereTwice) {
  files_.push_back(files_[1]);
  expect_refused("bench merge: part 2/3 is there more than once");
  files_ = {files_[0], files_[2]};
  expect_refused("part 2/3 is missing");
  files_ = {files_[0]};
  expect_refused("part 2/3 is missing");
}

TEST_F(BenchPartTest, RefusesPartsOfSomethingElse) {
  BenchPart other = part_of_three(2);
  other.settings["seed"] = 2;
  write(other, "part-2.json");
  expect_refused("seed is 2, not 1");
  other = part_of_three(2);
  other.settings["more"] = true;
  write(other, "part-2.json");
  expect_refused("more is true, not absent");
  other = part_of_three(2);
  other.settings.erase("seed");
  write(other, "part-2.json");
  expect_refused("seed is absent, not 1");
  other = part_of_three(2);
  other.command = "stability";
  write(other, "part-2.json");
  expect_refused("is of bench stability, but");
  other = part_of_three(2);
  other.shard = {2, 4};
  write(other, "part-2.json");
  expect_refused("is part 2/4 of a benchmark that");
}

TEST_F(BenchPartTest, RefusesPartsOfAnotherProgram) {
  edit("Foveola ", "Foveola 9");
  expect_refused("part-2.json: was measured by Foveola 9");
  files_ = {files_[1]};
  expect_refused("merge with the program that measured all parts");
}

TEST_F(BenchPartTest, RefusesWhatIsDamaged) {
  edit("least", "lease");
  expect_refused("part-2.json: is damaged");
  const std::string whole = read_file(files_[0]);
  const std::vector<std::string> texts = {
      "",
      "{}",
      "[1, 2]",
      "{\"foveola_bench_part\": 1}",
      whole.substr(0, whole.size() / 2),
      std::string(100'000, '['),
      "{\"foveola_bench_part\": 1, \"settings\": {\"a\": 1e999}}",
      whole.substr(0, whole.size() / 2) + "\xff" + whole.substr(whole.size() / 2)};
  for (const std::string& text : texts) {
    write_file(files_[1], text);
    expect_refused("part-2.json: is no part of a benchmark, or damaged");
  }
  fs::remove(files_[1]);
  expect_refused("part-2.json");
}

TEST_F(BenchPartTest, RefusesShardsThatAreNone) {
  for (const char* shard : {"0/3", "4/3", "2", "-1/3", "2/100001"}) {
    SCOPED_TRACE(shard);
    write(part_of_three(2), "part-2.json");
    edit("\"2/3\"", std::string("\"") + shard + "\"");
    expect_refused("part-2.json: is no part of a benchmark");
  }
}

TEST_F(BenchPartTest, WhatCannotBeReadInAPartNamesItsFile) {
  const std::vector<BenchPart> parts = read_whole_bench(files_);
  const auto count = [](const BenchPart& part) { return whole_number(part.results.at("sum"), 5); };
  EXPECT_THROW((void)read_part(parts[1], count), Error);
  try {
    (void)read_part(parts[1], count);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("part-2.json"), HasSubstr("is damaged")));
  }
}

TEST(WholeNumber, IsNothingElse) {
  EXPECT_EQ(whole_number(5, 5), 5U);
  for (const nlohmann::json& json :
       {nlohmann::json(6), nlohmann::json(-1), nlohmann::json(1.0), nlohmann::json("1"),
        nlohmann::json(nullptr), nlohmann::json(1e300)}) {
    EXPECT_THROW((void)whole_number(json, 5), std::out_of_range) << json;
  }
}

}  // namespace
}  // namespace foveola
