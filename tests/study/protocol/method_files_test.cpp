// The files that a protocol's methods read.
#include <utility>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

/// A folder with a protocol whose methods read masks, and the masks.
class ProtocolWithFiles : public ProtocolFolder {
 protected:
  ProtocolWithFiles() {
    write_mask("left.exr", 1.0F, 0.0F);
    write_mask("below/right.exr", 0.0F, 1.0F);
  }

  /// Of two pixels beside each other.
  void write_mask(const std::string& name, float left, float right) const {
    fs::create_directories((folder_ / name).parent_path());
    RgbImage image(2, 1);
    image.at(0, 0) = Rgb(left);
    image.at(1, 0) = Rgb(right);
    write_image(folder_ / name, image, 0.0);
  }

  Protocol load(const std::string& methods) const {
    return ProtocolFolder::load("name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [" +
                                methods + "]\n");
  }
};

/// The densities to the left and to the right.
std::pair<double, double> densities(const Protocol& protocol, const std::string& method) {
  const auto sampler = make_sampler(protocol, method);
  sampler->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  return {sampler->density_per_sr({-1.0F, 0.0F, 0.0F}),
          sampler->density_per_sr({1.0F, 0.0F, 0.0F})};
}

TEST_F(ProtocolWithFiles, FilesAreFoundFromItsOwnFolderWithTheirHashes) {
  const std::string hybrid =
      "hybrid:0.5*mask:file=below/right.exr+0.25*mask:file=below/right.exr,floor=1+0.25*fv";
  const Protocol protocol = load("\"od\", \"mask:file=./left.exr\", \"" + hybrid + "\"");
  EXPECT_THAT(protocol.methods, ElementsAre("od", "mask:file=./left.exr", hybrid));
  ASSERT_THAT(protocol.method_files, SizeIs(2));
  EXPECT_EQ(protocol.method_files[0].method, "mask:file=./left.exr");
  EXPECT_EQ(protocol.method_files[0].file, "./left.exr");
  EXPECT_EQ(protocol.method_files[0].sha256,
            sha256(std::string_view(read_file(folder_ / "left.exr"))));
  EXPECT_EQ(protocol.method_files[1].method, hybrid);
  EXPECT_EQ(protocol.method_files[1].file, "below/right.exr");
  const auto [left, right] = densities(protocol, "mask:file=./left.exr");
  EXPECT_GT(left, 0.0);
  EXPECT_EQ(right, 0.0);
}

TEST_F(ProtocolWithFiles, WhatHappensToAFileAfterwardsChangesNothing) {
  const Protocol protocol = load("\"mask:file=left.exr\", \"fv-map:file=left.exr\"");
  const auto before = densities(protocol, "mask:file=left.exr");
  write_mask("left.exr", 0.0F, 1.0F);
  EXPECT_EQ(densities(protocol, "mask:file=left.exr"), before);
  fs::remove(folder_ / "left.exr");
  EXPECT_EQ(densities(protocol, "mask:file=left.exr"), before);
  EXPECT_NE(make_sampler(protocol, "fv-map:file=left.exr"), nullptr);
}

TEST_F(ProtocolWithFiles, BadFilesAreRefusedWithTheirPlace) {
  folder_.write("text.png", "no image");
  write_mask("black.exr", 0.0F, 0.0F);
  const auto refused = [&](const std::string& file, const std::string& says) {
    EXPECT_THAT([&] { load("\"od\", \"mask:file=" + file + "\""); },
                ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":4:18: "), HasSubstr(says),
                                           Not(HasSubstr("\n")))));
  };
  refused("text.png", "text.png");
  refused("black.exr", "black all over");
  const test::TemporaryFolder elsewhere;
  fs::copy_file(folder_ / "left.exr", elsewhere / "left.exr");
  fs::create_symlink(elsewhere / "left.exr", folder_ / "outwards.exr");
  refused("outwards.exr", "a symbolic link that leads out of the folder");
}

}  // namespace
}  // namespace foveola::study
