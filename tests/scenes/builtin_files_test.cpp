#include "scenes/builtin_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/scenes/environment.h"

namespace foveola::scenes {
namespace {

using testing::HasSubstr;

TEST(BuiltinFiles, IsMadeOnceIntoTheCache) {
  const TemporaryFolder cache;
  const EnvironmentVariable cache_home("XDG_CACHE_HOME", cache.path().string());
  const std::filesystem::path file = require_builtin("studio-car");
  EXPECT_EQ(file.parent_path(), cache.path() / "foveola" / "scenes");
  EXPECT_EQ(read_file(file).substr(0, 4), "glTF");
  const std::string kept = read_file(file);
  const auto written = std::filesystem::last_write_time(file);
  require_builtin("studio-car");
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
}

TEST(BuiltinFiles, DamagedOnesAreMadeAgain) {
  const TemporaryFolder cache;
  const EnvironmentVariable cache_home("XDG_CACHE_HOME", cache.path().string());
  const std::filesystem::path file = require_builtin("studio-car");
  const std::string kept = read_file(file);
  write_file(file, kept.substr(0, kept.size() - 1));
  EXPECT_EQ(read_file(require_builtin("studio-car")), kept) << "after it was cut";
  std::string flipped = kept;
  flipped[kept.size() / 2] ^= 1;
  write_file(file, flipped);
  EXPECT_TRUE(is_whole_glb(file));
  EXPECT_EQ(read_file(require_builtin("studio-car")), kept) << "after a bit flipped";
  std::filesystem::remove(file.string() + ".sha256");
  EXPECT_EQ(read_file(require_builtin("studio-car")), kept) << "of an older program";
}

TEST(BuiltinFiles, VariantsAreKnownByTheirNames) {
  const std::filesystem::path variant = cached_builtin("arcade", 7).filename();
  EXPECT_NE(variant, cached_builtin("arcade").filename());
  EXPECT_EQ(variant_seed("arcade", variant), 7U);
  EXPECT_EQ(variant_seed("arcade", cached_builtin("arcade", 4'294'967'295U)), 4'294'967'295U);
  EXPECT_EQ(variant_seed("arcade", cached_builtin("arcade")), std::nullopt);
  EXPECT_EQ(variant_seed("church", variant), std::nullopt);
  EXPECT_EQ(variant_seed("arcade", "arcade-seed-7.glb"), std::nullopt);
  EXPECT_EQ(variant_seed("arcade", "arcade-seed-.glb"), std::nullopt);
  EXPECT_EQ(variant_seed("arcade", "arcade-seed-7-0123456789ab.glb"), std::nullopt);
}

TEST(BuiltinFiles, OnlyWholeFilesAreGlbs) {
  const TemporaryFolder folder;
  const std::string whole("glTF\2\0\0\0\24\0\0\0JSON{}  ", 20);
  EXPECT_TRUE(is_whole_glb(folder.write("whole", whole)));
  EXPECT_FALSE(is_whole_glb(folder.write("short", whole.substr(0, 19))));
  EXPECT_FALSE(is_whole_glb(folder.write("header", whole.substr(0, 11))));
  EXPECT_FALSE(is_whole_glb(folder.write("long", whole + " ")));
  EXPECT_FALSE(is_whole_glb(folder.write("other", "x" + whole.substr(1))));
  EXPECT_FALSE(is_whole_glb(folder.path() / "missing"));
  EXPECT_FALSE(is_whole_glb(folder.path()));
}

TEST(BuiltinFiles, WritesIntoANewFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "new" / "room.glb";
  EXPECT_GT(write_builtin("studio-car", file), 0U);
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(BuiltinFiles, FolderThatIsAFileIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("taken", "x");
  EXPECT_THAT([&] { write_builtin("studio-car", file / "room.glb"); },
              testing::ThrowsMessage<Error>(HasSubstr("choose another folder")));
}

TEST(BuiltinFiles, CacheThatCannotBeKeptIsNamed) {
  const TemporaryFolder cache;
  const EnvironmentVariable cache_home("XDG_CACHE_HOME", cache.path().string());
  const std::filesystem::path file = cached_builtin("studio-car");
  std::filesystem::create_directories(file);
  EXPECT_THAT([&] { require_builtin("studio-car"); },
              testing::ThrowsMessage<Error>(testing::AllOf(
                  HasSubstr(file.string() + ": is a folder"), HasSubstr("remove it"))));
  std::filesystem::remove_all(cache / "foveola");
  cache.write("foveola", "a file");
  EXPECT_THAT([&] { require_builtin("studio-car"); },
              testing::ThrowsMessage<Error>(HasSubstr("set XDG_CACHE_HOME to another folder")));
  EXPECT_THAT(cache.entries(), testing::ElementsAre("foveola"));
}

/// Whatever became of it, it can be made again.
TEST(BuiltinFiles, CachedLinkThatLeadsNowhereIsReplaced) {
  const TemporaryFolder cache;
  const EnvironmentVariable cache_home("XDG_CACHE_HOME", cache.path().string());
  const std::filesystem::path file = cached_builtin("studio-car");
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::create_symlink("/nowhere/at/all", file);
  EXPECT_TRUE(is_whole_glb(require_builtin("studio-car")));
  EXPECT_FALSE(std::filesystem::is_symlink(file));
}

}  // namespace
}  // namespace foveola::scenes
