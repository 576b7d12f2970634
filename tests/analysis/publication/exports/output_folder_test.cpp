#include "analysis/publication/exports/output_folder.h"

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

// SHA-256 of "abc": FIPS 180-4's example.
constexpr const char* digest_of_abc =
    "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

/// Stages files of these names, each with "abc" in it, and publishes them.
PublishedFiles publish(const fs::path& folder, const std::vector<std::string>& names) {
  StagedFolder staged(folder);
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    files.push_back(staged.path() / name);
    fs::create_directories(files.back().parent_path());
    write_file(files.back(), "abc");
  }
  return staged.publish(files);
}

TEST(OutputFolder, IsMadeOnceAndUsedAgain) {
  const test::TemporaryFolder folder;
  check_output_folder(folder / "results");
  EXPECT_FALSE(fs::exists(folder / "results"));
  make_output_folder(folder / "results");
  EXPECT_TRUE(fs::is_directory(folder / "results"));
  check_output_folder(folder / "results");
  make_output_folder(folder / "results");
  EXPECT_TRUE(fs::is_empty(folder / "results"));
}

TEST(OutputFolder, IsRefusedBeforeTheWork) {
  const test::TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_THAT([&] { check_output_folder(folder / "file"); },
              ThrowsMessage<Error>(HasSubstr("is a file, not a folder")));
  EXPECT_THROW(check_output_folder(folder / "no" / "where"), Error);
}

TEST(OutputFolder, LosesWhatItNoLongerWrites) {
  const test::TemporaryFolder folder;
  const fs::path results = folder / "results";
  EXPECT_THAT(publish(results, {"bids/sub-1/gaze", "bids/sub-2/gaze", "table"}).files,
              ElementsAre(results / "manifest.sha256", results / "bids/sub-1/gaze",
                          results / "bids/sub-2/gaze", results / "table"));
  EXPECT_THAT(publish(results, {"bids/sub-2/gaze", "report"}).staying, IsEmpty());
  EXPECT_FALSE(fs::exists(results / "bids/sub-1"));
  EXPECT_TRUE(fs::exists(results / "bids/sub-2/gaze"));
  EXPECT_FALSE(fs::exists(results / "table"));
  EXPECT_EQ(read_file(results / "manifest.sha256"),
            fmt::format("{0}  bids/sub-2/gaze\n{0}  report\n", digest_of_abc));
}

TEST(OutputFolder, KeepsWhatAPersonChangedOrPutThere) {
  const test::TemporaryFolder folder;
  const fs::path results = folder / "results";
  publish(results, {"own/changed", "own/unchanged", "table"});
  write_file(results / "own" / "changed", "abd");
  write_file(results / "own" / "notes", "abc");
  EXPECT_THAT(publish(results, {"table"}).staying, ElementsAre(results / "own/changed"));
  EXPECT_EQ(read_file(results / "own" / "changed"), "abd");
  EXPECT_EQ(read_file(results / "own" / "notes"), "abc");
  EXPECT_FALSE(fs::exists(results / "own" / "unchanged"));
}

TEST(OutputFolder, RemovesNothingThroughALinkOrOutside) {
  const test::TemporaryFolder folder;
  const fs::path results = folder / "results";
  publish(results, {"bids/gaze", "link", "table"});
  fs::rename(results / "bids", folder / "moved");
  fs::create_directory_symlink(folder / "moved", results / "bids");
  fs::rename(results / "link", folder / "linked");
  fs::create_symlink(folder / "linked", results / "link");
  std::string manifest = read_file(results / "manifest.sha256");
  for (const std::string& path :
       {std::string("../linked"), (folder / "linked").string(), std::string("bids/../../linked")}) {
    manifest += fmt::format("{}  {}\n", digest_of_abc, path);
  }
  write_file(results / "manifest.sha256", manifest + "no line of a manifest\n");
  EXPECT_THAT(publish(results, {"table"}).staying,
              ElementsAre(results / "bids/gaze", results / "link"));
  EXPECT_EQ(read_file(folder / "moved" / "gaze"), "abc");
  EXPECT_EQ(read_file(folder / "linked"), "abc");
  EXPECT_TRUE(fs::is_symlink(results / "bids"));
}

// Other files each time, and kills at any moment: what is left at the end is what came last.
TEST(OutputFolder, AKillLeavesNothingBehindForGood) {
  constexpr int kills = 40;
  constexpr int files = 12;
  const test::TemporaryFolder folder;
  std::mt19937 random(2018);
  std::uniform_int_distribution<int> moment_us(0, 20'000);
  for (int kill = 0; kill < kills; ++kill) {
    std::vector<std::string> names;
    for (int file = 0; file < files; ++file) {
      names.push_back(fmt::format("run-{}/{}/gaze", kill, file));
    }
    const pid_t child = ::fork();
    if (child == 0) {
      publish(folder / "results", names);
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(moment_us(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  EXPECT_THAT(publish(folder / "results", {"table"}).staying, IsEmpty());
  std::vector<std::string> left;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "results")) {
    left.push_back(entry.path().filename());
  }
  EXPECT_THAT(left, UnorderedElementsAre("manifest.sha256", "table"));
}

TEST(OutputFolder, IsWrittenByOneProgramAtATime) {
  const test::TemporaryFolder folder;
  {
    const StagedFolder first(folder / "results");
    EXPECT_THAT([&] { publish(folder / "results", {"table"}); },
                ThrowsMessage<Error>(HasSubstr("is being written by another analysis")));
  }
  EXPECT_FALSE(fs::exists(folder / "results")) << "nothing was published";
}

}  // namespace
}  // namespace foveola::analysis
