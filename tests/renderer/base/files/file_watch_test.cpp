#include "renderer/base/files/file_watch.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <stop_token>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// Nothing counts as done while a writer keeps its file open.
constexpr FileWatchTiming patient = {.quiet_after_whole_file = std::chrono::milliseconds(1),
                                     .quiet_while_open = std::chrono::hours(1)};

class FileWatchTest : public ::testing::Test {
 protected:
  FileWatchTest() { watch_.watch({folder_.write("scene.glb", "first")}); }

  /// The change that was made, when it comes.
  FileChange change() {
    auto waiting = std::async(std::launch::async,
                              [this] { return watch_.wait_for_change(stop_.get_token()); });
    if (waiting.wait_for(test::patience) != std::future_status::ready) {
      stop_.request_stop();
    }
    return waiting.get();
  }
  bool changed() { return change() == FileChange::of_watched_file; }

  /// Whether none comes, as far as can be told while the kernel tells of another one.
  bool unchanged() {
    std::stop_source stop;
    auto waiting =
        std::async(std::launch::async, [&] { return watch_.wait_for_change(stop.get_token()); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
    return waiting.get() != FileChange::of_watched_file;
  }

  void rename_into_place(const std::string& content, const std::string& name = "scene.glb") {
    fs::rename(folder_.write("new", content), folder_ / name);
  }

  test::TemporaryFolder folder_;
  std::stop_source stop_;
  FileWatch watch_{patient};
};

TEST_F(FileWatchTest, SeesAFileThatIsRenamedIntoItsPlace) {
  rename_into_place("second");
  EXPECT_TRUE(changed());
  rename_into_place("third");
  EXPECT_TRUE(changed()) << "the file that was watched is another one by now";
}

TEST_F(FileWatchTest, SeesAFileThatIsWrittenInPlaceOnceItIsClosed) {
  std::ofstream file(folder_ / "scene.glb");
  file << "sec" << std::flush;
  EXPECT_TRUE(unchanged());
  file << "ond";
  file.close();
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, TakesAFileThatStaysOpenForWrittenAfterAWhile) {
  FileWatch watch({.quiet_after_whole_file = std::chrono::milliseconds(1),
                   .quiet_while_open = std::chrono::milliseconds(2)});
  watch.watch({folder_ / "scene.glb"});
  std::ofstream file(folder_ / "scene.glb");
  file << "second" << std::flush;
  EXPECT_EQ(watch.wait_for_change(stop_.get_token()), FileChange::of_watched_file);
}

TEST_F(FileWatchTest, TellsOtherFilesInTheFolderApart) {
  rename_into_place("text", "notes.txt");
  EXPECT_EQ(change(), FileChange::of_another_file);
  rename_into_place("second");
  rename_into_place("text", "notes.txt");
  EXPECT_EQ(change(), FileChange::of_watched_file) << "one of two";
}

// As a log is, into which the program itself may write.
TEST_F(FileWatchTest, AnotherFileThatStaysOpenHoldsNothingUp) {
  rename_into_place("second");
  std::ofstream log(folder_ / "log");
  log << "line" << std::flush;
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, SeesAFileThatWasMissing) {
  watch_.watch({folder_ / "later.bin"});
  rename_into_place("content", "later.bin");
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, SeesAFileThatWasRemovedAndComesBack) {
  fs::remove(folder_ / "scene.glb");
  EXPECT_TRUE(unchanged()) << "there is nothing to be read";
  rename_into_place("second");
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, SeesWhatALinkLeadsTo) {
  const test::TemporaryFolder other;
  other.write("real.glb", "first");
  fs::create_symlink(other / "real.glb", folder_ / "link.glb");
  watch_.watch({folder_ / "link.glb"});
  fs::rename(other.write("new", "second"), other / "real.glb");
  EXPECT_TRUE(changed());
}

/// Ways to a file that become other ways.
class WayToAFile : public FileWatchTest {
 protected:
  WayToAFile() {
    folder_.write("one/a/scene.glb", "first");
    folder_.write("two/a/scene.glb", "second");
  }

  /// Whether it sees the change that was made, and the next one in the file that the name has now.
  void expect_followed(const fs::path& name) {
    EXPECT_TRUE(changed());
    fs::rename(folder_.write("new", "third"), name);
    EXPECT_TRUE(changed()) << "in the file that the name has now";
  }
};

TEST_F(WayToAFile, AFolderIsRemovedAndMadeAgain) {
  watch_.watch({folder_ / "one/a/scene.glb"});
  fs::remove_all(folder_ / "one");
  fs::rename(folder_ / "two", folder_ / "one");
  expect_followed(folder_ / "one/a/scene.glb");
}

TEST_F(WayToAFile, FoldersAreExchanged) {
  watch_.watch({folder_ / "one/a/scene.glb"});
  ASSERT_EQ(::renameat2(AT_FDCWD, (folder_ / "one").c_str(), AT_FDCWD, (folder_ / "two").c_str(),
                        RENAME_EXCHANGE),
            0);
  expect_followed(folder_ / "one/a/scene.glb");
}

TEST_F(WayToAFile, ALinkIsTurned) {
  for (const auto& [link, one, two, name] :
       {std::array{"last.glb", "one/a/scene.glb", "two/a/scene.glb", "last.glb"},
        std::array{"middle", "one", "two", "middle/a/scene.glb"}}) {
    fs::create_symlink(one, folder_ / link);
    watch_.watch({folder_ / name});
    fs::create_symlink(two, folder_ / "turned");
    fs::rename(folder_ / "turned", folder_ / link);
    expect_followed(folder_ / "two/a/scene.glb");
  }
}

TEST_F(WayToAFile, AFolderThatWasMissingComes) {
  watch_.watch({folder_ / "three/a/scene.glb"});
  fs::rename(folder_ / "two", folder_ / "three");
  expect_followed(folder_ / "three/a/scene.glb");
}

TEST_F(WayToAFile, AFileOrItsFolderIsGone) {
  FileWatch watch({.quiet_after_whole_file = std::chrono::milliseconds(1),
                   .quiet_while_open = std::chrono::milliseconds(2)});
  watch.watch({folder_ / "one/a/scene.glb", folder_ / "two/a/scene.glb"});
  fs::remove(folder_ / "one/a/scene.glb");
  EXPECT_EQ(watch.wait_for_change(stop_.get_token()), FileChange::of_watched_file);
  fs::rename(folder_ / "two", folder_ / "elsewhere");
  EXPECT_EQ(watch.wait_for_change(stop_.get_token()), FileChange::of_watched_file);
}

TEST_F(FileWatchTest, WatchesTheFilesThatItWasToldOfLast) {
  watch_.watch({folder_ / "other.glb"});
  rename_into_place("second");
  EXPECT_TRUE(unchanged());
  rename_into_place("second", "other.glb");
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, AFolderThatIsNotThereIsLeftOut) {
  watch_.watch({folder_ / "missing/scene.glb", folder_ / "scene.glb"});
  rename_into_place("second");
  EXPECT_TRUE(changed());
}

TEST_F(FileWatchTest, SeesWhatChangedBeforeAnybodyWaited) {
  rename_into_place("second");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(changed());
  EXPECT_TRUE(unchanged()) << "and tells of it once";
}

}  // namespace
}  // namespace foveola
