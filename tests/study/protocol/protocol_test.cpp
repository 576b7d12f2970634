#include "study/protocol/protocol.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/image/image_file.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string minimal = R"(name = "small"
title = "A small one"
scenes = ["arcade", "room"]
methods = ["od", "fv"]
)";

class ProtocolFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::path(testing::TempDir()) /
            ("protocol_" + std::to_string(::getpid()) + "_" +
             testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml");
  }
  void TearDown() override { fs::remove(path_); }

  Protocol load(const std::string& text) {
    write_file(path_, text);
    return load_protocol(path_);
  }

  fs::path path_;
};

TEST_F(ProtocolFile, NeedsOnlyANameATitleScenesAndMethods) {
  const Protocol protocol = load(minimal);
  EXPECT_EQ(protocol.name, "small");
  EXPECT_EQ(protocol.title, "A small one");
  EXPECT_THAT(protocol.methods, ElementsAre("od", "fv"));
  ASSERT_EQ(protocol.scenes.size(), 2U);
  EXPECT_EQ(protocol.scenes[1].name, "room");
  EXPECT_EQ(protocol.scenes[1].line, 3);
  EXPECT_EQ(protocol.scenes[1].column, 21);
  EXPECT_EQ(protocol.text, minimal);
  EXPECT_EQ(protocol.sha256, sha256(std::string_view(minimal)));
  EXPECT_EQ(protocol.machine.frame_rate_hz, MachineModel{}.frame_rate_hz);
  EXPECT_TRUE(protocol.background.empty());
  EXPECT_FALSE(protocol.display.profile);
  EXPECT_FALSE(protocol.tracker.profile);
  EXPECT_FALSE(protocol.tracker.validation);
}

TEST_F(ProtocolFile, EveryKeyIsRead) {
  const Protocol protocol = load(minimal + R"(
[machine]
samples_per_second = 5000
frame_rate_hz = 90.5
[film]
width = 64
height = 32
max_depth = 3
spare_done_contrast = 0.02
[display]
view_width = 20
view_height = 30
fov_deg = [60, 80]
fill_unsampled = true
[display.lens]
axis = [0.55, 0.5]
k1 = 0.25
k2 = -0.125
[tracker]
rate_hz = 250
latency_s = 0.005
precision_deg = 0.3
[tracker.validation]
points = 5
max_accuracy_deg = 2
max_precision_deg = 0.75
max_data_loss = 0.25
correct = true
attempts = 4
[timing]
mark_timeout_s = 7.5
rating_s = 2
[reference]
samples_per_pixel = 9
samples_per_object = 10
[[background]]
id = "age"
text = "How old?"
minimum = 18
maximum = 99
[[background]]
id = "vr"
text = "Used to it?"
)");
  EXPECT_EQ(protocol.machine.samples_per_second, 5000.0);
  EXPECT_EQ(protocol.machine.frame_rate_hz, 90.5);
  EXPECT_EQ(protocol.film.width, 64);
  EXPECT_EQ(protocol.film.height, 32);
  EXPECT_EQ(protocol.film.max_depth, 3);
  EXPECT_EQ(protocol.film.spare_done_contrast, 0.02);
  EXPECT_EQ(protocol.display.view_width, 20);
  EXPECT_EQ(protocol.display.view_height, 30);
  EXPECT_EQ(protocol.display.horizontal_fov_deg, 60.0);
  EXPECT_EQ(protocol.display.vertical_fov_deg, 80.0);
  EXPECT_TRUE(protocol.display.fill_unsampled);
  EXPECT_EQ(protocol.display.lens, (RadialLens{.axis = {0.55F, 0.5F}, .k1 = 0.25F, .k2 = -0.125F}));
  EXPECT_EQ(protocol.tracker.simulated.rate_hz, 250.0);
  EXPECT_EQ(protocol.tracker.simulated.latency_s, 0.005);
  EXPECT_EQ(protocol.tracker.simulated.precision_deg, 0.3);
  ASSERT_TRUE(protocol.tracker.validation);
  EXPECT_EQ(protocol.tracker.validation->points, 5);
  EXPECT_EQ(protocol.tracker.validation->gate.max_accuracy_deg, 2.0);
  EXPECT_EQ(protocol.tracker.validation->gate.max_precision_deg, 0.75);
  EXPECT_EQ(protocol.tracker.validation->gate.max_data_loss, 0.25);
  EXPECT_TRUE(protocol.tracker.validation->correct);
  EXPECT_EQ(protocol.tracker.validation->attempts, 4);
  EXPECT_EQ(protocol.timing.mark_timeout_s, 7.5);
  EXPECT_EQ(protocol.timing.rating_s, 2.0);
  EXPECT_EQ(protocol.reference.samples_per_pixel, 9);
  EXPECT_EQ(protocol.reference.samples_per_object, 10);
  ASSERT_EQ(protocol.background.size(), 2U);
  EXPECT_EQ(protocol.background[0].maximum, 99);
  EXPECT_EQ(protocol.background[1].minimum, 1);
  EXPECT_EQ(protocol.background[1].maximum, 5);
}

// Square pixels: at twice the width of its height, tan(45 degrees) / 2 = tan(26.565 degrees).
TEST_F(ProtocolFile, OneFieldOfViewMakesSquarePixels) {
  const auto display = [&](const std::string& keys) {
    return load(minimal + "[display]\n" + keys).display;
  };
  const DisplaySettings wide = display("fov_deg = 90\nview_width = 200\nview_height = 100\n");
  EXPECT_EQ(wide.horizontal_fov_deg, 90.0);
  EXPECT_NEAR(wide.vertical_fov_deg, 2.0 * 26.565051, 1e-5);
  const DisplaySettings square = display("fov_deg = 100\nview_width = 64\nview_height = 64\n");
  EXPECT_EQ(square.vertical_fov_deg, 100.0);
}

TEST_F(ProtocolFile, TheRightEyesLensIsTheLeftOnesMirrored) {
  const auto lens = [&](const std::string& eye) {
    return load(minimal + "[display.lens]\naxis = [0.75, 0.4]\nk1 = 0.1\n" + eye).display.lens;
  };
  EXPECT_EQ(lens("eye = \"left\"\n"), lens(""));
  EXPECT_EQ(lens("eye = \"right\"\n"), (RadialLens{.axis = {0.25F, 0.4F}, .k1 = 0.1F}));
}

TEST_F(ProtocolFile, APointerHeldInPlaceNeedsNobodyToPoint) {
  const Protocol protocol = load(
      "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\n"
      "methods = [\"od\", \"pointer:azimuth=10\"]\n");
  EXPECT_THAT(protocol.methods, ElementsAre("od", "pointer:azimuth=10"));
}

/// A folder with a protocol whose methods read masks, and the masks.
class ProtocolWithFiles : public testing::Test {
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
    folder_.write("p.toml",
                  "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [" + methods + "]\n");
    return load_protocol(folder_ / "p.toml");
  }

  test::TemporaryFolder folder_;
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
  ASSERT_THAT(protocol.method_files, testing::SizeIs(2));
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
                ThrowsMessage<Error>(AllOf(HasSubstr((folder_ / "p.toml").string() + ":4:18: "),
                                           HasSubstr(says), testing::Not(HasSubstr("\n")))));
  };
  refused("text.png", "text.png");
  refused("black.exr", "black all over");
  const test::TemporaryFolder elsewhere;
  fs::copy_file(folder_ / "left.exr", elsewhere / "left.exr");
  fs::create_symlink(elsewhere / "left.exr", folder_ / "outwards.exr");
  refused("outwards.exr", "a symbolic link that leads out of the folder");
}

TEST_F(ProtocolFile, EveryShippedProtocolLoads) {
  for (const char* name : {"demo", "real-scenes"}) {
    EXPECT_EQ(load_protocol(find_protocol(name)).name, name);
  }
}

TEST_F(ProtocolFile, AnUnknownNameListsTheKnownOnes) {
  EXPECT_THAT([] { find_protocol("no-such-study"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("no-such-study"), HasSubstr("demo"))));
}

/// What is wrong, at which line and column, and what the message must say.
struct Fault {
  const char* name;
  std::string text;
  std::string place;
  std::string says;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

/// A protocol whose second method is a mask of `file`.
Fault with_mask(const char* name, const std::string& file, const char* says) {
  return {name,
          "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"mask:file=" + file +
              "\"]\n",
          "4:18", says};
}

class ProtocolFault : public testing::TestWithParam<Fault> {};

TEST_P(ProtocolFault, IsRefusedWithItsPlace) {
  const fs::path path = fs::path(testing::TempDir()) / (std::string("fault_") + GetParam().name);
  write_file(path, GetParam().text);
  EXPECT_THAT([&] { load_protocol(path); },
              ThrowsMessage<Error>(AllOf(HasSubstr(path.string() + ":" + GetParam().place + ":"),
                                         HasSubstr(GetParam().says))));
  fs::remove(path);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, ProtocolFault,
    testing::Values(
        Fault{"no_toml", "name = \n", "1:8", ""},
        Fault{"unknown_key", minimal + "colour = 3\n", "5:1", "colour"},
        Fault{"unknown_table", minimal + "[lens]\nk = 1\n", "5:2", "lens"},
        Fault{"unknown_key_in_table", minimal + "[film]\ndepth = 3\n", "6:1", "film.depth"},
        Fault{"unknown_method",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"xx\"]\n", "4:18",
              "xx"},
        Fault{"method_twice",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\", \"od\"]\n", "4:18",
              "twice"},
        with_mask("mask_that_is_missing", "no_such.png", "a file that does not exist"),
        with_mask("mask_by_an_absolute_path", "/etc/passwd", "an absolute path"),
        with_mask("mask_out_of_the_folder", "../x.png", "leads out of the folder"),
        with_mask("mask_that_is_a_folder", ".", "not a regular file"),
        Fault{"method_with_a_pointer",
              "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\n"
              "methods = [\"od\", \"hybrid:1*od+1*pointer:radius=5\"]\n",
              "4:18", "follows a pointer"},
        Fault{"third_eye", minimal + "[display.lens]\neye = \"third\"\n", "6:7", "no eye"},
        Fault{"no_scenes", "name = \"a\"\ntitle = \"b\"\nscenes = []\nmethods = [\"od\"]\n", "3:10",
              "scenes"},
        Fault{"scene_is_a_number",
              "name = \"a\"\ntitle = \"b\"\nscenes = [3]\nmethods = [\"od\"]\n", "3:10", "scenes"},
        Fault{"missing_methods", "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\n", "1:1",
              "methods"},
        Fault{"text_for_number", minimal + "[film]\nwidth = \"wide\"\n", "6:9", "film.width"},
        Fault{"fraction_for_integer", minimal + "[film]\nwidth = 64.5\n", "6:9", "film.width"},
        Fault{"negative_size", minimal + "[film]\nwidth = -64\n", "6:9", "film.width"},
        Fault{"nan_rate", minimal + "[machine]\nframe_rate_hz = nan\n", "6:17", "frame_rate_hz"},
        Fault{"infinite_rate", minimal + "[machine]\nframe_rate_hz = inf\n", "6:17",
              "frame_rate_hz"},
        Fault{"flat_view", minimal + "[display]\nfov_deg = 180\n", "6:11", "fov_deg"},
        Fault{"folding_lens", minimal + "[display]\n[display.lens]\nk1 = -3\n", "6:1", "fold"},
        Fault{"profile_of_no_tracker", minimal + "[tracker]\nprofile = \"fove1\"\n", "6:11",
              "fove0, hid"},
        Fault{"seven_points", minimal + "[tracker.validation]\npoints = 7\n", "6:10", "5 or 9"},
        Fault{"no_attempts", minimal + "[tracker.validation]\nattempts = 0\n", "6:12",
              "tracker.validation.attempts"},
        Fault{"unknown_gate", minimal + "[tracker.validation]\nmax_error = 1\n", "6:1",
              "tracker.validation.max_error"},
        Fault{"table_is_a_number", minimal + "film = 3\n", "5:8", "film"},
        Fault{"question_without_text", minimal + "[[background]]\nid = \"age\"\n", "5:1", "text"},
        Fault{"question_twice",
              minimal + "[[background]]\nid = \"a\"\ntext = \"b\"\n[[background]]\nid = \"a\"\n"
                        "text = \"c\"\n",
              "8:1", "twice"}),
    [](const testing::TestParamInfo<Fault>& test) { return test.param.name; });

TEST_F(ProtocolFile, ScenesAreFoundInOrder) {
  const Protocol protocol = load(minimal);
  const auto find = [](const std::string& name) {
    return SceneSource{.name = name, .camera_position = Vec3(0.0F), .objects = {{.name = "x"}}};
  };
  const std::vector<SceneSource> sources = find_scenes(protocol, find);
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[1].name, "room");
}

TEST_F(ProtocolFile, ScenesThatCannotBeUsedAreNamedWithTheirPlace) {
  const Protocol protocol = load(minimal);
  const auto missing = [](const std::string& name) -> SceneSource {
    throw Error(name, "no such scene");
  };
  EXPECT_THAT(
      [&] { find_scenes(protocol, missing); },
      ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":3:11"), HasSubstr("arcade"))));
  const auto bare = [](const std::string& name) { return SceneSource{.name = name}; };
  EXPECT_THAT([&] { find_scenes(protocol, bare); }, ThrowsMessage<Error>(HasSubstr("objects")));
}

}  // namespace
}  // namespace foveola::study
