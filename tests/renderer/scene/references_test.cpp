#include "renderer/scene/references.h"

#include <optional>
#include <stdexcept>
#include <vector>

#include <sys/stat.h>

#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

namespace fs = std::filesystem;

class ConfinedFile : public InTemporaryFolder {
 protected:
  ConfinedFile() {
    fs::create_directories(scene() / "maps");
    write("secret.bin", "secret");
    write("scene/wood grain+1.png", "wood");
    write("scene/maps/100%.png", "map");
  }

  fs::path scene() const { return folder() / "scene"; }

  std::string refusal_of(const std::string& uri) const {
    try {
      const fs::path file = confined_file(scene(), uri);
      ADD_FAILURE() << uri << " was allowed as " << file;
    } catch (const std::runtime_error& refusal) {
      return refusal.what();
    }
    return {};
  }
};

TEST_F(ConfinedFile, FindsFilesInTheFolderAndBelow) {
  EXPECT_EQ(confined_file(scene(), "wood grain+1.png"),
            fs::canonical(scene() / "wood grain+1.png"));
  EXPECT_EQ(confined_file(scene(), "wood%20grain%2B1.png"),
            fs::canonical(scene() / "wood grain+1.png"));
  EXPECT_EQ(confined_file(scene(), "./maps/100%25.png"),
            fs::canonical(scene() / "maps" / "100%.png"));
  EXPECT_EQ(confined_file(scene(), "maps/100%.png"), fs::canonical(scene() / "maps" / "100%.png"));
}

TEST_F(ConfinedFile, PathsOutOfTheFolderNameAFileInIt) {
  const std::vector<std::string> ways = {
      "../secret.bin",  "maps/../../secret.bin", "%2e%2e/secret.bin",    "..%2Fsecret.bin",
      "..\\secret.bin", "../../x/secret.bin",    "gone/../../secret.bin"};
  for (const std::string& uri : ways) {
    EXPECT_THAT(refusal_of(uri), HasSubstr("\"secret.bin\", a file that does not exist"));
    EXPECT_EQ(confined_file_if_there(scene(), uri), std::nullopt) << uri;
  }
  write("scene/secret.bin", "no secret");
  for (const std::string& uri : ways) {
    EXPECT_EQ(confined_file(scene(), uri), fs::canonical(scene() / "secret.bin")) << uri;
  }
  EXPECT_THAT(refusal_of(".."), HasSubstr("out of the folder"));
}

TEST_F(ConfinedFile, PathsThatReturnIntoTheFolderStay) {
  const fs::path map = fs::canonical(scene() / "maps" / "100%.png");
  for (const char* uri : {"./gone/../maps/100%25.png", "maps/../maps/./100%25.png",
                          "gone\\..\\maps\\100%25.png", "maps//100%25.png"}) {
    EXPECT_EQ(confined_file(scene(), uri), map) << uri;
  }
}

TEST_F(ConfinedFile, NamesMayBeInAnotherCase) {
  const fs::path map = fs::canonical(scene() / "maps" / "100%.png");
  EXPECT_EQ(confined_file(scene(), "Maps/100%25.PNG"), map);
  EXPECT_EQ(confined_file(scene(), "C:\\MAPS\\WOOD%20GRAIN+1.PNG"),
            fs::canonical(scene() / "wood grain+1.png"));
  fs::create_directory(folder() / "outside");
  write("outside/a.png", "a");
  fs::create_directory_symlink("../outside", scene() / "link");
  EXPECT_EQ(confined_file_if_there(scene(), "link/A.png"), std::nullopt) << "not searched";
}

/// As exporters write them on other machines: the file's name is what they have in common.
TEST_F(ConfinedFile, PathsOfOtherMachinesNameAFileHere) {
  const fs::path wood = fs::canonical(scene() / "wood grain+1.png");
  for (const char* uri : {"/home/artist/maps/wood grain+1.png", "%2Fhome/wood%20grain%2B1.png",
                          "C:\\Users\\artist\\wood grain+1.png", "c:/maps/wood%20grain+1.png",
                          "file:///home/artist/wood%20grain+1.png", "file:wood grain+1.png",
                          "\\\\server\\share\\wood grain+1.png"}) {
    EXPECT_EQ(confined_file(scene(), uri), wood) << uri;
  }
  EXPECT_EQ(confined_file(scene(), "maps\\100%.png"), fs::canonical(scene() / "maps/100%.png"));
  EXPECT_THAT(refusal_of((folder() / "secret.bin").string()),
              HasSubstr("\"secret.bin\", a file that does not exist"));
  EXPECT_THAT(refusal_of("%2Fetc/passwd"), HasSubstr("\"passwd\", a file that does not exist"));
}

TEST_F(ConfinedFile, TwoFoldersThatBecomeOneAreNamed) {
  Warnings warnings;
  ForeignReferences references;
  for (const char* name : {"/a/wood.png", "/a/wood.png", "grass.png", "x/../grass.png",
                           "/a/stone.png", "maps/stone.png"}) {
    references.add(name, warnings);
  }
  EXPECT_EQ(warnings.count(), 0U);
  references.add("C:\\b\\wood.png", warnings);
  EXPECT_THAT(warnings.lines(),
              ElementsAre("/a/wood.png and a file of the same name in another folder are "
                          "shown as one, the only wood.png here (C:\\b\\wood.png)"));
  for (const char* name : {"../stone.png", "/a/grass.png"}) {
    references.add(name, warnings);
  }
  EXPECT_EQ(warnings.count(), 3U);
}

TEST_F(ConfinedFile, RefusesSchemes) {
  for (const char* uri :
       {"http://example.org/a.png", "HTTPS://example.org/a", "data:image/webp;base64,AAAA"}) {
    EXPECT_THAT(refusal_of(uri), HasSubstr("not a relative path")) << uri;
  }
}

TEST_F(ConfinedFile, RefusesLinksThatLeaveTheFolder) {
  fs::create_symlink("../secret.bin", scene() / "file link");
  fs::create_directory_symlink("..", scene() / "folder link");
  EXPECT_THAT(refusal_of("file link"), HasSubstr("a symbolic link that leads out"));
  EXPECT_THAT(refusal_of("folder link/secret.bin"), HasSubstr("a symbolic link that leads out"));
}

TEST_F(ConfinedFile, FollowsLinksThatStay) {
  fs::create_symlink("maps/100%.png", scene() / "link");
  EXPECT_EQ(confined_file(scene(), "link"), fs::canonical(scene() / "maps" / "100%.png"));
}

TEST_F(ConfinedFile, ANeighbourWithALongerNameIsOutside) {
  fs::create_directory(folder() / "scene-2");
  write("scene-2/a.bin", "a");
  fs::create_symlink("../scene-2/a.bin", scene() / "link");
  EXPECT_THAT(refusal_of("link"), HasSubstr("leads out"));
}

TEST_F(ConfinedFile, RefusesWhatIsNoFile) {
  ASSERT_EQ(::mkfifo((scene() / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal_of("pipe"), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal_of("maps"), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal_of("missing.png"), HasSubstr("\"missing.png\", a file that does not exist"));
  EXPECT_THAT(refusal_of(""), HasSubstr("not the name of a file"));
  EXPECT_THAT(refusal_of("maps%00.png"), HasSubstr("\"maps?.png\", not the name of a file"));
}

TEST_F(ConfinedFile, OnlyWhatIsMissingInsideTheFolderMayBeMissing) {
  EXPECT_EQ(confined_file_if_there(scene(), "missing.png"), std::nullopt);
  EXPECT_EQ(confined_file_if_there(scene(), "missing/a.png"), std::nullopt);
  EXPECT_EQ(confined_file_if_there(scene(), "maps/100%25.png"),
            fs::canonical(scene() / "maps" / "100%.png"));
  fs::create_symlink("../secret.bin", scene() / "file link");
  for (const std::string uri : {"http://example.org/a.png", "file link", "maps", "..", ""}) {
    EXPECT_THROW(confined_file_if_there(scene(), uri), std::runtime_error) << uri;
  }
}

TEST_F(ConfinedFile, DoesNotQuoteAWholeBook) {
  EXPECT_LT(refusal_of(std::string(100000, 'a')).size(), 300U);
}

}  // namespace
}  // namespace foveola::test
