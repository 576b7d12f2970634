#include "study/protocol/protocol.h"

#include <sstream>

#include <gtest/gtest.h>

#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

using ProtocolFile = ProtocolFolder;

TEST(ProtocolText, KeysThatAreNoLettersMayBeNamed) {
  test::TemporaryFolder folder;
  const std::string text =
      minimal + "[texts]\nready_keys = \"[←] [1] [Leertaste] [⏎] [] [mark]\"\n";
  EXPECT_NO_THROW(load_protocol(folder.write("p.toml", text)));
}

std::string of_rating(const std::string& id) {
  return minimal + "[[rating]]\nid = \"" + id + "\"\ntext = \"How bad?\"\n";
}

TEST_F(ProtocolFile, IdsNameFilesOnEveryFileSystem) {
  // A name in a folder has up to 255 bytes, and an analysis writes ratios-of-means-ID.tex.
  EXPECT_NO_THROW((void)load(of_rating(std::string(64, 'x'))));
  for (const std::size_t length : {65, 300}) {
    EXPECT_THAT([&] { (void)load(of_rating(std::string(length, 'x'))); },
                ThrowsMessage<Error>(AllOf(HasSubstr("p.toml:6:"), HasSubstr("at most 64"))));
  }
  EXPECT_THAT([&] { (void)load(of_rating("if") + of_rating("IF").substr(minimal.size())); },
              ThrowsMessage<Error>(AllOf(HasSubstr("p.toml:9:"),
                                         HasSubstr("'IF' differs from 'if' in letter case"))));
  EXPECT_THAT(
      [&] {
        (void)load(of_rating("if") + "[[mark]]\nid = \"if_response\"\ninstruction = \"Now.\"\n");
      },
      ThrowsMessage<Error>(HasSubstr("'if_response' is that of a response time")));
  // A record that has such ids can be read.
  EXPECT_NO_THROW((void)read_protocol(of_rating(std::string(65, 'x')), "p.toml"));
}

struct AlikeNames {
  std::string text;
  std::string place;
  std::string name;
};
void PrintTo(const AlikeNames& alike, std::ostream* out) { *out << alike.name; }

class NamesOfColumns : public ProtocolFolder, public testing::WithParamInterface<AlikeNames> {};

const std::string of_q =
    "[[questionnaire]]\nid = \"q\"\ntitle = \"Q\"\n"
    "[[questionnaire.question]]\nid = \"age\"\ntext = \"Age?\"\n";

// SQLite 3 refuses a table with the columns q.age and Q.AGE: "duplicate column name".
TEST_P(NamesOfColumns, DifferInMoreThanLetterCase) {
  folder_.write("case.toml",
                "title = \"Case\"\n[[question]]\nid = \"a\"\ntext = \"?\"\n"
                "[[question]]\nid = \"A\"\ntext = \"?\"\n");
  EXPECT_THAT([&] { (void)load(GetParam().text); },
              ThrowsMessage<Error>(AllOf(HasSubstr("p.toml:" + GetParam().place),
                                         HasSubstr("'" + GetParam().name + "' "),
                                         HasSubstr("letter case"))));
  EXPECT_NO_THROW((void)read_protocol(GetParam().text, path_)) << "as a record may have it";
}

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, NamesOfColumns,
    testing::Values(
        AlikeNames{minimal + of_q +
                       "[[questionnaire]]\nid = \"Q\"\ntitle = \"Q\"\n"
                       "[[questionnaire.question]]\nid = \"AGE\"\ntext = \"?\"\n",
                   "12:6:", "Q"},
        AlikeNames{minimal + of_q + "[[questionnaire.question]]\nid = \"AGE\"\ntext = \"?\"\n",
                   "12:6:", "AGE"},
        AlikeNames{minimal + "[[questionnaire]]\nid = \"q\"\nfile = \"case\"\n", "7:8:", "A"},
        AlikeNames{"name = \"a\"\ntitle = \"b\"\nscenes = [\"hall\", \"Hall\"]\n"
                   "methods = [\"od\"]\n",
                   "3:19:", "Hall"},
        AlikeNames{minimal + "[[mark]]\nid = \"Looking_Around\"\ninstruction = \"Now.\"\n",
                   "6:6:", "Looking_Around"},
        AlikeNames{of_rating("if") + "[[mark]]\nid = \"IF_response\"\ninstruction = \"Now.\"\n",
                   "9:6:", "IF_response"}));

// Records of 0.1.0 have them.
TEST(ProtocolText, OfARecordNamesTheKeysThatItsProgramHad) {
  const std::string consent = "[J] Ja    [N] Nein";
  const Protocol protocol =
      read_protocol(minimal + "[texts]\nconsent_keys = \"" + consent + "\"\n", "p.toml");
  EXPECT_EQ(protocol.texts.at("consent_keys"), consent);
}

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

  // What the published study has; that the other defaults are those of the reference is in
  // SchemaAndReaders.
  EXPECT_EQ(protocol.object_choice, ObjectChoice::per_scene);
  EXPECT_THAT(protocol.marks, ElementsAre(testing::Field(&MarkEntry::id, "outline"),
                                          testing::Field(&MarkEntry::id, "material")));
  ASSERT_EQ(protocol.ratings.size(), 1U);
  EXPECT_EQ(protocol.ratings[0].id, "artifacts");
  EXPECT_EQ(protocol.ratings[0].minimum, 1.0);
  EXPECT_EQ(protocol.ratings[0].maximum, 5.0);
  EXPECT_THAT(protocol.ratings[0].labels, ElementsAre("none", "not discernible at all"));
  ASSERT_EQ(protocol.phases.size(), 1U);
  EXPECT_EQ(name_of(protocol.phases[0]), "trials");
  EXPECT_FALSE(protocol.display.profile || protocol.tracker.profile ||
               protocol.tracker.validation || protocol.reaction);
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
adaptive_contrast = 0.02
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
[tracker.filter]
extrapolate_s = 0.03
hold_s = 0.25
[tracker.filter.one_euro]
min_cutoff_hz = 1.5
beta_per_deg = 0.5
derivative_cutoff_hz = 8
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
  EXPECT_EQ(protocol.film.adaptive_contrast, 0.02);
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
  EXPECT_EQ(protocol.tracker.filter,
            (GazeFilterSettings{.one_euro = OneEuroSettings{.min_cutoff_hz = 1.5,
                                                            .beta_per_deg = 0.5,
                                                            .derivative_cutoff_hz = 8.0},
                                .extrapolate_s = 0.03,
                                .hold_s = 0.25}));
  EXPECT_EQ(protocol.timing.mark_timeout_s, 7.5);
  EXPECT_EQ(protocol.timing.rating_s, 2.0);
  EXPECT_EQ(protocol.reference.samples_per_pixel, 9);
  EXPECT_EQ(protocol.reference.samples_per_object, 10);
}

TEST_F(ProtocolFile, ADisplayThatWasKeptNeedsNoFileButTheKeptProfile) {
  const DisplaySettings defaults = read_recorded_display(minimal, "kept", "");
  EXPECT_EQ(defaults.horizontal_fov_deg, 100.0);
  const std::string named = minimal + "[display]\nprofile = \"gone\"\n";
  const std::string profile =
      "title = \"Gone\"\nkind = \"headset\"\nwidth_px = 200\nheight_px = 100\n"
      "refresh_rate_hz = 60\nhorizontal_fov_deg = 80\nvertical_fov_deg = 70\n"
      "scan_out = { duration_ms = 1.0, provenance = \"assumed\" }\n";
  const DisplaySettings display = read_recorded_display(named, "kept", profile);
  EXPECT_EQ(display.horizontal_fov_deg, 80.0);
  EXPECT_EQ(display.vertical_fov_deg, 70.0);
  EXPECT_EQ(read_recorded_display(named + "fov_deg = [60, 50]\n", "kept", profile).vertical_fov_deg,
            50.0);
  EXPECT_THROW(read_recorded_display(named, "kept", ""), Error);
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

/// The settings of a shipped protocol, line by line, without comments, what names it, and the speed
/// of the simulated machine, which is fitted in its scenes.
std::vector<std::string> settings_in(const std::string& name) {
  std::vector<std::string> lines;
  std::istringstream text(read_file(find_protocol(name)));
  for (std::string line; std::getline(text, line);) {
    line.erase(std::min(line.find("  #"), line.size()));
    const bool is_named =
        line.starts_with("name =") || line.starts_with("title =") || line.starts_with("scenes =");
    const bool is_first_title = lines.size() < 3;
    if (!line.empty() && !line.starts_with('#') && !(is_named && is_first_title) &&
        !line.starts_with("samples_per_second =")) {
      lines.push_back(line);
    }
  }
  return lines;
}

TEST_F(ProtocolFile, ThePublishedStudyInItsOwnScenesIsTheSameInAllElse) {
  EXPECT_EQ(settings_in("koskela2018-original"), settings_in("koskela2018"));
  EXPECT_THAT(load_protocol(find_protocol("koskela2018-original")).scenes,
              ElementsAre(testing::Field(&SceneEntry::name, "bmw"),
                          testing::Field(&SceneEntry::name, "classroom"),
                          testing::Field(&SceneEntry::name, "conference"),
                          testing::Field(&SceneEntry::name, "sibenik"),
                          testing::Field(&SceneEntry::name, "sponza")));
}

TEST_F(ProtocolFile, ScenesAreFoundInOrder) {
  const Protocol protocol = load(minimal);
  const auto find = [&](const std::string& name, const std::filesystem::path& folder) {
    EXPECT_EQ(folder, path_.parent_path());
    return SceneSource{.name = name, .camera_position = Vec3(0.0F), .objects = {{.name = "x"}}};
  };
  const std::vector<SceneSource> sources = find_scenes(protocol, find);
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[1].name, "room");
}

TEST_F(ProtocolFile, ScenesThatCannotBeUsedAreNamedWithTheirPlace) {
  const Protocol protocol = load(minimal);
  const auto missing = [](const std::string& name, const auto& /*folder*/) -> SceneSource {
    throw Error(name, "no such scene");
  };
  EXPECT_THAT(
      [&] { find_scenes(protocol, missing); },
      ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":3:11"), HasSubstr("arcade"))));
  const auto bare = [](const std::string& name, const auto& /*folder*/) {
    return SceneSource{.name = name};
  };
  EXPECT_THAT([&] { find_scenes(protocol, bare); }, ThrowsMessage<Error>(HasSubstr("objects")));
}

}  // namespace
}  // namespace foveola::study
