#include "study/protocol/protocol.h"

#include <utility>
#include <vector>

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

std::vector<std::string> phases_of(const Protocol& protocol) {
  std::vector<std::string> names;
  for (const PhaseEntry& phase : protocol.phases) {
    names.push_back(name_of(phase));
  }
  return names;
}

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
  EXPECT_EQ(protocol.language, "en");
  EXPECT_EQ(protocol.scene_order, Order::random);
  EXPECT_EQ(protocol.method_order, Order::random);
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_scene);
  ASSERT_EQ(protocol.marks.size(), 2U);
  EXPECT_EQ(protocol.marks[0].id, "outline");
  EXPECT_EQ(protocol.marks[1].id, "material");
  ASSERT_EQ(protocol.ratings.size(), 1U);
  EXPECT_EQ(protocol.ratings[0].id, "artifacts");
  EXPECT_EQ(protocol.ratings[0].minimum, 1.0);
  EXPECT_EQ(protocol.ratings[0].maximum, 5.0);
  EXPECT_THAT(protocol.ratings[0].labels, ElementsAre("none", "not discernible at all"));
  EXPECT_TRUE(protocol.practice.empty());
  EXPECT_EQ(protocol.catch_trials.count, 0);
  EXPECT_FALSE(protocol.reaction);
  EXPECT_TRUE(protocol.questionnaires.empty());
  EXPECT_THAT(phases_of(protocol), ElementsAre("trials"));
  EXPECT_FALSE(protocol.analysis.participants);
  EXPECT_FALSE(protocol.display.profile);
  EXPECT_FALSE(protocol.tracker.profile);
  EXPECT_FALSE(protocol.tracker.validation);
}

TEST_F(ProtocolFile, EveryKeyOfItsSettingsIsRead) {
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
}

TEST_F(ProtocolFile, EveryKeyOfItsProcedureIsRead) {
  const Protocol protocol = load(R"(language = "fi"
scene_order = "latin"
method_order = "williams"
object = "per method"
phases = ["after", "consent", "reaction", "trials"]
)" + minimal + R"(
[texts]
consent = "Suostun."
ready_title = "Valmiina {trial}?"
[[mark]]
id = "shape"
instruction = "Press at its shape."
[[rating]]
id = "noise"
text = "How noisy?"
minimum = 0
maximum = 2
labels = ["not", "some", "very"]
[[rating]]
id = "liked"
text = "Did you like it?"
kind = "choice"
options = [{ label = "yes", value = 1 }, { label = "no" }]
[[practice]]
scene = "room"
method = "fv"
[catch_trials]
count = 4
timeout_s = 5.5
[reaction]
presses = 3
shortest_wait_s = 0.5
longest_wait_s = 0.75
[[questionnaire]]
id = "after"
title = "Afterwards"
intro = "Two more."
source = "Somebody 1999"
[[questionnaire.question]]
id = "years"
text = "For how long?"
kind = "number"
minimum = 0
maximum = 80.5
[[questionnaire.question]]
id = "words"
text = "What else?"
kind = "text"
required = false
[analysis]
participants = 12
alpha = 0.01
[[analysis.primary]]
measure = "shape"
method = "fv"
[[analysis.primary]]
measure = "noise"
method = "od"
baseline = "fv"
[analysis.equivalence_margins]
shape = 1.25
noise = 0.5
)");
  EXPECT_EQ(protocol.language, "fi");
  EXPECT_EQ(protocol.scene_order, Order::latin);
  EXPECT_EQ(protocol.method_order, Order::williams);
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_method);
  EXPECT_THAT(phases_of(protocol), ElementsAre("after", "consent", "reaction", "trials"));
  EXPECT_EQ(text_of(protocol.texts, "consent"), "Suostun.");
  EXPECT_EQ(text_of(protocol.texts, "ready_title"), "Valmiina {trial}?");
  ASSERT_EQ(protocol.marks.size(), 1U);
  EXPECT_EQ(protocol.marks[0].id, "shape");
  EXPECT_EQ(protocol.marks[0].instruction, "Press at its shape.");
  ASSERT_EQ(protocol.ratings.size(), 2U);
  EXPECT_EQ(protocol.ratings[0].text, "How noisy?");
  EXPECT_EQ(protocol.ratings[0].maximum, 2.0);
  EXPECT_THAT(protocol.ratings[0].labels, ElementsAre("not", "some", "very"));
  EXPECT_EQ(protocol.ratings[1].kind, QuestionKind::choice);
  ASSERT_EQ(protocol.ratings[1].options.size(), 2U);
  EXPECT_EQ(protocol.ratings[1].options[0].value, 1.0);
  EXPECT_EQ(protocol.ratings[1].options[1].label, "no");
  EXPECT_FALSE(protocol.ratings[1].options[1].value);
  ASSERT_EQ(protocol.practice.size(), 1U);
  EXPECT_EQ(protocol.practice[0].scene, "room");
  EXPECT_EQ(protocol.practice[0].method, "fv");
  EXPECT_EQ(protocol.catch_trials.count, 4);
  EXPECT_EQ(protocol.catch_trials.timeout_s, 5.5);
  ASSERT_TRUE(protocol.reaction);
  EXPECT_EQ(protocol.reaction->presses, 3);
  EXPECT_EQ(protocol.reaction->shortest_wait_s, 0.5);
  EXPECT_EQ(protocol.reaction->longest_wait_s, 0.75);
  const Questionnaire& after = questionnaire_of(protocol, "after");
  EXPECT_EQ(after.title, "Afterwards");
  EXPECT_EQ(after.intro, "Two more.");
  EXPECT_EQ(after.source, "Somebody 1999");
  ASSERT_EQ(after.questions.size(), 2U);
  EXPECT_EQ(after.questions[0].kind, QuestionKind::number);
  EXPECT_EQ(after.questions[0].maximum, 80.5);
  EXPECT_TRUE(after.questions[0].required);
  EXPECT_EQ(after.questions[1].kind, QuestionKind::text);
  EXPECT_FALSE(after.questions[1].required);
  EXPECT_EQ(protocol.analysis.participants, 12);
  EXPECT_EQ(protocol.analysis.alpha, 0.01);
  ASSERT_EQ(protocol.analysis.primary.size(), 2U);
  EXPECT_EQ(protocol.analysis.primary[0].measure, "shape");
  EXPECT_EQ(protocol.analysis.primary[0].baseline, "od") << "the protocol's first";
  EXPECT_EQ(protocol.analysis.primary[1].method, "od");
  EXPECT_EQ(protocol.analysis.primary[1].baseline, "fv");
  EXPECT_THAT(protocol.analysis.equivalence_margins,
              ElementsAre(testing::Pair("noise", 0.5), testing::Pair("shape", 1.25)));
}

TEST_F(ProtocolFile, PhasesHaveAnOrderOfTheirOwn) {
  const auto questionnaire = [](const std::string& id) {
    return "[[questionnaire]]\nid = \"" + id +
           "\"\ntitle = \"t\"\n[[questionnaire.question]]\nid = \"q\"\ntext = \"?\"\n";
  };
  EXPECT_THAT(
      phases_of(load(minimal + "[reaction]\n[texts]\nconsent = \"I agree\"\n" +
                     questionnaire("more") + questionnaire("debrief") +
                     questionnaire("background") + "[tracker.validation]\n")),
      ElementsAre("consent", "background", "validation", "reaction", "trials", "debrief", "more"));
}

// Settings cascade from the protocol to the scene to the method, key by key.
TEST_F(ProtocolFile, OverridesHoldWhereTheySaySomething) {
  const Protocol protocol = load(minimal + R"(
[timing]
mark_timeout_s = 60
[film]
max_depth = 5
[[override]]
method = "fv"
timing.rating_s = 9
film.max_depth = 7
[[override]]
scene = "room"
method = "fv"
film.width = 100
[[override]]
scene = "room"
film = { max_depth = 6, height = 99 }
fill_unsampled = true
)");
  const TrialSettings plain = settings_of(protocol, "arcade", "od");
  EXPECT_EQ(plain.film.max_depth, 5);
  EXPECT_EQ(plain.film.height, FilmSettings{}.height);
  EXPECT_EQ(plain.timing.mark_timeout_s, 60.0);
  EXPECT_FALSE(plain.fill_unsampled);
  const TrialSettings scene = settings_of(protocol, "room", "od");
  EXPECT_EQ(scene.film.max_depth, 6);
  EXPECT_EQ(scene.film.height, 99);
  EXPECT_TRUE(scene.fill_unsampled);
  const TrialSettings method = settings_of(protocol, "arcade", "fv");
  EXPECT_EQ(method.film.max_depth, 7);
  EXPECT_EQ(method.timing.rating_s, 9.0);
  EXPECT_EQ(method.timing.mark_timeout_s, 60.0);
  const TrialSettings both = settings_of(protocol, "room", "fv");
  EXPECT_EQ(both.film.max_depth, 7) << "the method comes after the scene";
  EXPECT_EQ(both.film.height, 99);
  EXPECT_EQ(both.film.width, 100);
  EXPECT_TRUE(both.fill_unsampled);
}

TEST_F(ProtocolFile, ATextThatWasKeptIsReadLikeItsFile) {
  const Protocol protocol = read_protocol(minimal, "/nowhere/p.toml");
  EXPECT_EQ(protocol.title, "A small one");
  EXPECT_EQ(protocol.path, "/nowhere/p.toml");
  EXPECT_EQ(protocol.sha256, load(minimal).sha256);
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
  for (const char* name : {"demo", "koskela2018", "real-scenes"}) {
    EXPECT_EQ(load_protocol(find_protocol(name)).name, name);
  }
}

// What the issue of re-creating the published study says of it.
TEST_F(ProtocolFile, ThePublishedStudyIsTheOneThatWasPublished) {
  const Protocol protocol = load_protocol(find_protocol("koskela2018"));
  EXPECT_EQ(protocol.scenes.size(), 5U);
  EXPECT_THAT(protocol.methods, ElementsAre("od", "vp", "fv"));
  EXPECT_EQ(protocol.scene_order, Order::random);
  EXPECT_EQ(protocol.method_order, Order::random);
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_scene);
  EXPECT_THAT(phases_of(protocol), ElementsAre("background", "trials", "debrief"));
  EXPECT_EQ(protocol.film.width, 4096);
  EXPECT_EQ(protocol.film.height, 2048);
  EXPECT_EQ(protocol.machine.samples_per_second, 7e6);
  EXPECT_EQ(protocol.display.profile->name, "fove0");
  EXPECT_EQ(protocol.tracker.profile->name, "fove0");
  EXPECT_EQ(protocol.analysis.participants, 16);
  const std::vector<Question>& background = questionnaire_of(protocol, "background").questions;
  ASSERT_EQ(background.size(), 6U);
  EXPECT_EQ(background[1].options[0].label, "female");
  EXPECT_EQ(background[1].options[0].value, 5.0);
  EXPECT_EQ(background[1].options[1].label, "male");
  EXPECT_EQ(background[1].options[1].value, 1.0);
  for (std::size_t i = 2; i < 6; ++i) {
    EXPECT_EQ(background[i].kind, QuestionKind::likert);
    EXPECT_EQ(background[i].maximum - background[i].minimum, 4.0) << "five points";
  }
}

TEST_F(ProtocolFile, AnUnknownNameListsTheKnownOnes) {
  EXPECT_THAT([] { find_protocol("no-such-study"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("no-such-study"), HasSubstr("demo"))));
}

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
