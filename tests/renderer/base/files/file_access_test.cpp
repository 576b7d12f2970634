#include "renderer/base/files/file_access.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// home/ with a file of its own and one below; a secret beside it.
class ConfinedPath : public testing::Test {
 protected:
  ConfinedPath() {
    folder_.write("secret.png", "secret");
    folder_.write("home/a.png", "a");
    folder_.write("home/below/b.png", "b");
  }

  fs::path home() const { return folder_ / "home"; }

  std::string refusal_of(const fs::path& relative) const {
    try {
      const fs::path file = confined_path(home(), relative);
      ADD_FAILURE() << relative << " was allowed as " << file;
    } catch (const std::runtime_error& refusal) {
      return refusal.what();
    }
    return {};
  }

  test::TemporaryFolder folder_;
};

TEST_F(ConfinedPath, FindsFilesInTheFolderAndBelow) {
  EXPECT_EQ(confined_path(home(), "a.png"), fs::canonical(home() / "a.png"));
  EXPECT_EQ(confined_path(home(), "./below/b.png"), fs::canonical(home() / "below" / "b.png"));
}

TEST_F(ConfinedPath, RefusesWhatLeavesTheFolder) {
  EXPECT_EQ(refusal_of(folder_ / "secret.png"), "an absolute path");
  EXPECT_EQ(refusal_of("../secret.png"), "a path that leads out of the folder");
  EXPECT_EQ(refusal_of("below/../a.png"), "a path that leads out of the folder");
}

TEST_F(ConfinedPath, FollowsOnlyLinksThatStay) {
  fs::create_symlink("../secret.png", home() / "link");
  fs::create_directory_symlink("..", home() / "up");
  fs::create_symlink("below/b.png", home() / "inside");
  EXPECT_EQ(refusal_of("link"), "a symbolic link that leads out of the folder");
  EXPECT_EQ(refusal_of("up/secret.png"), "a symbolic link that leads out of the folder");
  EXPECT_EQ(confined_path(home(), "inside"), fs::canonical(home() / "below" / "b.png"));
}

TEST_F(ConfinedPath, RefusesWhatIsNoFile) {
  ASSERT_EQ(::mkfifo((home() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal_of("pipe"), "not a regular file");
  EXPECT_EQ(refusal_of("below"), "not a regular file");
  EXPECT_EQ(refusal_of("missing.png"), "a file that does not exist");
  EXPECT_EQ(refusal_of(""), "not the name of a file");
  EXPECT_EQ(refusal_of(std::string("a.png\0b", 7)), "not the name of a file");
}

}  // namespace
}  // namespace foveola
