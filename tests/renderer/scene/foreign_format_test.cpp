#include "renderer/scene/foreign_format.h"

#include <string>

#include "renderer/base/error.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

/// What is said of a file of that name and content; empty if it may be read.
std::string complaint(const std::string& name, const std::string& content) {
  const test::TemporaryFolder folder;
  return test::error_of([&] { require_readable_format(folder.write(name, content)); });
}

TEST(ForeignFormat, BlendersOwnFilesAreKnownByTheirFirstBytes) {
  const auto is_explained = AllOf(HasSubstr("is a Blender file, which Foveola does not read"),
                                  HasSubstr("File > Export > glTF 2.0"));
  EXPECT_THAT(complaint("room.blend", "BLENDER-v304"), is_explained);
  EXPECT_THAT(complaint("room.glb", "BLENDER-v304"), is_explained);
}

/// What Blender has compressed begins as any other gzip or Zstandard file does.
TEST(ForeignFormat, CompressedBlenderFilesAreKnownByTheirNames) {
  EXPECT_THAT(complaint("room.blend", "\x28\xb5\x2f\xfd"), HasSubstr("is a Blender file"));
  EXPECT_THAT(complaint("ROOM.BLEND", "\x1f\x8b\x08"), HasSubstr("is a Blender file"));
}

TEST(ForeignFormat, OthersAreNamedWithTheWayToGltf) {
  EXPECT_THAT(complaint("a.fbx", "x"), AllOf(HasSubstr("FBX"), HasSubstr("File > Import")));
  EXPECT_THAT(complaint("a", "Kaydara FBX Binary  "), HasSubstr("FBX"));
  EXPECT_THAT(complaint("a.usdz", "PK"), HasSubstr("USD archive"));
  EXPECT_THAT(complaint("a", "PXR-USDC"), HasSubstr("USD file"));
  EXPECT_THAT(complaint("a.dae", "<COLLADA"), HasSubstr("COLLADA"));
  EXPECT_THAT(complaint("a.STL", "solid"), HasSubstr("STL"));
  EXPECT_THAT(complaint("a.ply", "ply"), HasSubstr("PLY"));
  EXPECT_THAT(complaint("a.abc", ""), HasSubstr("Alembic"));
  EXPECT_THAT(complaint("a.3ds", ""), HasSubstr("3D Studio"));
  EXPECT_THAT(complaint("a.max", ""), AllOf(HasSubstr("3ds Max"), HasSubstr("export it from")));
}

TEST(ForeignFormat, WhatMayBeReadIsNotRefused) {
  EXPECT_EQ(complaint("a.glb", "glTF"), "");
  EXPECT_EQ(complaint("a.max", "glTF"), "");
  EXPECT_EQ(complaint("a.gltf", "{}"), "");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0"), "");
  EXPECT_EQ(complaint("a", ""), "");
}

}  // namespace
}  // namespace foveola
