#include "scenes/file_search.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/scenes/environment.h"
#include "tests/unprivileged.h"

namespace foveola::scenes {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FileSearchTest : public testing::Test {
 protected:
  FileSearchTest() { test::open_to_all(folder.path()); }

  std::string in(const std::string& name) const { return (folder / name).string(); }

  TemporaryFolder folder;

 private:
  EnvironmentVariable data_home_{"XDG_DATA_HOME", (folder / "data").string()};
};

TEST_F(FileSearchTest, LooksIntoFoldersAndTheirSubfolders) {
  folder.write("a/b/c/hall.glb", "too deep");
  EXPECT_FALSE(search_folder(folder / "a", "hall.glb").file.has_value());
  const fs::path below = folder.write("a/b/hall.glb", "x");
  EXPECT_EQ(search_folder(folder / "a", "hall.glb").file, below);
  const fs::path beside = folder.write("a/hall.glb", "x");
  EXPECT_EQ(search_folder(folder / "a", "hall.glb").file, beside);
}

TEST_F(FileSearchTest, GoesThroughThePathAndThenWhatWasFetched) {
  const EnvironmentVariable path("FOVEOLA_SCENE_PATH", in("missing") + "::" + in("a"));
  EXPECT_FALSE(search_scene_path("hall.glb").file.has_value());
  const fs::path fetched = folder.write("data/foveola/scenes/hall.glb", "x");
  EXPECT_EQ(search_scene_path("hall.glb").file, fetched);
  const fs::path own = folder.write("a/hall.glb", "x");
  const FileSearch search = search_scene_path("hall.glb");
  EXPECT_EQ(search.file, own);
  EXPECT_THAT(search.obstacles, IsEmpty()) << "found all the same";
}

/// A user who has fetched nothing has no such folder, and nothing to mend.
TEST_F(FileSearchTest, NothingFetchedIsNoObstacle) {
  const EnvironmentVariable path("FOVEOLA_SCENE_PATH", "");
  EXPECT_THAT(search_scene_path("hall.glb").obstacles, IsEmpty());
  folder.write("data/foveola/scenes", "a file");
  EXPECT_THAT(search_scene_path("hall.glb").obstacles, ElementsAre(HasSubstr("Not a directory")));
}

TEST_F(FileSearchTest, SaysWhichFoldersAreNone) {
  folder.write("file", "x");
  const EnvironmentVariable path("FOVEOLA_SCENE_PATH", in("missing") + ":" + in("file"));
  EXPECT_THAT(
      search_scene_path("hall.glb").obstacles,
      ElementsAre(in("missing") + ": No such file or directory", in("file") + ": Not a directory"));
}

TEST_F(FileSearchTest, SaysWhatBearsTheNameWithoutBeingAFile) {
  fs::create_directories(folder / "a/hall.glb");
  fs::create_symlink("/nowhere/at/all", folder / "a/room.glb");
  ASSERT_EQ(::mkfifo(in("a/pipe.glb").c_str(), 0600), 0);
  EXPECT_THAT(search_folder(folder / "a", "hall.glb").obstacles,
              ElementsAre(in("a/hall.glb") + " is a folder"));
  EXPECT_THAT(search_folder(folder / "a", "room.glb").obstacles,
              ElementsAre(in("a/room.glb") + " is a broken link"));
  EXPECT_THAT(search_folder(folder / "a", "pipe.glb").obstacles,
              ElementsAre(in("a/pipe.glb") + " is not a regular file"));
  const fs::path file = folder.write("a/sub/room.glb", "x");
  EXPECT_EQ(search_folder(folder / "a", "room.glb").file, file);
}

TEST_F(FileSearchTest, SaysWhichFoldersAreLocked) {
  folder.write("a/locked/hall.glb", "x");
  test::open_to_all(folder / "a");
  const test::Locked locked(folder / "a/locked");
  const test::Unprivileged unprivileged;
  for (const char* const from : {"a", "a/locked"}) {
    const FileSearch search = search_folder(folder / from, "hall.glb");
    EXPECT_FALSE(search.file.has_value());
    EXPECT_THAT(search.obstacles, ElementsAre(in("a/locked") + ": Permission denied"));
  }
}

TEST_F(FileSearchTest, ObstaclesStandInBrackets) {
  EXPECT_EQ(in_brackets({}), "");
  EXPECT_EQ(in_brackets({"a: gone", "b is a folder"}), " (a: gone; b is a folder)");
}

}  // namespace
}  // namespace foveola::scenes
