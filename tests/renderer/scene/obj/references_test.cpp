#include "renderer/scene/obj/references.h"

#include <gtest/gtest.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

using ObjReferences = InTemporaryFolder;

TEST_F(ObjReferences, HaveEitherSlash) {
  const auto file = std::filesystem::canonical(write("sub/a b.png", "x"));
  EXPECT_EQ(find_obj_reference(folder(), "sub/a b.png"), file);
  EXPECT_EQ(find_obj_reference(folder(), " sub\\a b.png "), file);
  EXPECT_EQ(find_obj_reference(folder(), ".\\sub\\a b.png"), file);
  EXPECT_EQ(find_obj_reference(folder(), "other/a b.png"), std::nullopt);
}

TEST_F(ObjReferences, AreNotPercentEncoded) {
  const auto file = std::filesystem::canonical(write("50%25.png", "x"));
  EXPECT_EQ(find_obj_reference(folder(), "50%25.png"), file);
  EXPECT_EQ(find_obj_reference(folder(), "50%.png"), std::nullopt);
}

TEST_F(ObjReferences, MayBeInAnotherCase) {
  const auto file = std::filesystem::canonical(write("Sub/A.PNG", "x"));
  EXPECT_EQ(find_obj_reference(folder(), "sub/a.png"), file);
  const auto exact = std::filesystem::canonical(write("Sub/a.png", "y"));
  EXPECT_EQ(find_obj_reference(folder(), "sub/a.png"), exact);
  EXPECT_EQ(find_obj_reference(folder(), "sub/A.png"), std::nullopt) << "one of two";
}

TEST_F(ObjReferences, StayInTheFolder) {
  write("a.png", "x");
  std::filesystem::create_directory(folder() / "inner");
  std::filesystem::create_symlink("../a.png", folder() / "inner" / "LINK.png");
  const auto find = [&](const char* name) { return find_obj_reference(folder() / "inner", name); };
  EXPECT_EQ(find("..\\a.png"), std::nullopt);
  EXPECT_EQ(find("C:\\a.png"), std::nullopt);
  EXPECT_EQ(find("/a.png"), std::nullopt);
  EXPECT_THROW(find("link.png"), std::runtime_error);
}

}  // namespace
}  // namespace foveola::test
