// What `study check` warns of.
#include "study/protocol/cautions.h"

#include <fmt/format.h>

#include "study/protocol/untranslated.h"
#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

class Cautions : public ProtocolFolder {
 protected:
  /// Of a protocol whose scenes are each a file of its own.
  std::vector<std::string> of(const std::string& text) const {
    const Protocol protocol = load(text);
    std::vector<SceneSource> scenes;
    for (const SceneEntry& scene : protocol.scenes) {
      scenes.push_back({.name = scene.name, .file = folder_ / (scene.name + ".glb")});
      scenes.back().exposure_stops = 0.0;
    }
    return cautions(protocol, scenes);
  }

  static std::string with_methods(const std::string& methods) {
    return "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\", \"t\"]\nmethods = [" + methods + "]\n";
  }
};

TEST_F(Cautions, AreNotNeededForTheProtocolsOfFoveola) {
  for (const char* name : {"demo", "koskela2018-original", "koskela2018"}) {
    const Protocol protocol = load_protocol(find_protocol(name));
    std::vector<SceneSource> scenes;
    for (const SceneEntry& scene : protocol.scenes) {
      scenes.push_back({.name = scene.name, .file = scene.name});
      scenes.back().exposure_stops = 0.0;
    }
    EXPECT_THAT(cautions(protocol, scenes), IsEmpty()) << name;
  }
}

TEST_F(Cautions, OneMethodInTwoSpellings) {
  EXPECT_THAT(
      of(with_methods("\"od\", \"fv\", \"fv:acuity=reddy\"")),
      ElementsAre(path_.string() +
                  ":4:24: 'fv:acuity=reddy' is the same method as 'fv', with the same settings; "
                  "remove one of them, unless a method is to be compared with itself"));
  EXPECT_THAT(of(with_methods("\"fv\", \"fv:exponent=1,cutoff=80\", \"fv:measure=planar\"")),
              SizeIs(2));
  EXPECT_THAT(
      of(with_methods("\"fv\", \"fv-paper\", \"fv:cutoff=79.9\", \"fv:acuity=guenter\", \"vp\", "
                      "\"vp-rect\", \"hybrid:0.9*fv+0.1*od\", \"hybrid:0.8*fv+0.2*od\", "
                      "\"crop:width=10\", \"crop:azimuth=90\"")),
      IsEmpty());
}

TEST_F(Cautions, FewScenesThatAPlanTakesForRandom) {
  const std::string text = with_methods("\"od\", \"fv\"");
  const std::string plan = "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n";
  EXPECT_THAT(of(text + plan),
              ElementsAre(AllOf(StartsWith(path_.string() + ":5:"),
                                HasSubstr("2 scenes are too few to generalise to other scenes"))));
  EXPECT_THAT(of(text + "[analysis]\nscenes = \"fixed\"\n" + plan), IsEmpty());
  EXPECT_THAT(of(text), IsEmpty());
}

TEST_F(Cautions, HybridsWhoseWeightsDoNotAddUpTo1) {
  EXPECT_THAT(of(with_methods("\"od\", \"hybrid:3*fv+1*od\"")),
              ElementsAre(AllOf(StartsWith(path_.string() + ":4:18: the weights of"),
                                HasSubstr("add up to 4, not to 1: of the samples, fv 75 %"))));
}

TEST_F(Cautions, OneMethodWithTwoSettingsIsTwo) {
  const std::string methods = with_methods("\"fv\", \"fv:acuity=reddy\"");
  const std::string filled = "[[override]]\nmethod = \"fv:acuity=reddy\"\nfill_unsampled = true\n";
  EXPECT_THAT(of(methods + filled), IsEmpty());
  EXPECT_THAT(of(methods + "[[override]]\nmethod = \"fv\"\nfill_unsampled = false\n"), SizeIs(1));
}

TEST_F(Cautions, OneSceneUnderTwoNames) {
  const Protocol protocol = load(with_methods("\"od\""));
  const fs::path file = folder_.write("hall.glb", "");
  fs::create_symlink(file, folder_ / "link.glb");
  std::vector<SceneSource> scenes = {
      {.name = "s", .file = file, .camera_position = Vec3(1.0F)},
      {.name = "t", .file = folder_ / "link.glb", .camera_position = Vec3(1.0F)}};
  scenes[0].exposure_stops = 0.0;
  scenes[1].exposure_stops = 1.0;
  EXPECT_THAT(cautions(protocol, scenes),
              ElementsAre(AllOf(
                  StartsWith(path_.string() + ":3:16: the scene 't' is 's' under another name"),
                  HasSubstr("link.glb; remove one of them"))));
  scenes[1].camera_position = Vec3(2.0F);
  EXPECT_THAT(cautions(protocol, scenes), IsEmpty()) << "another place in it";
}

TEST_F(Cautions, ScenesWithoutAnExposure) {
  const Protocol protocol = load(with_methods("\"od\""));
  std::vector<SceneSource> scenes = {{.name = "s", .file = "s.glb"},
                                     {.name = "t", .file = "t.glb"}};
  scenes[0].exposure_stops = -3.0;
  EXPECT_THAT(cautions(protocol, scenes),
              ElementsAre(AllOf(StartsWith(path_.string() + ":3:16: the scene 't' has no exposure"),
                                HasSubstr("exposure_stops"))));
}

TEST_F(Cautions, TextsThatStayEnglish) {
  const auto german = [](const std::string& tables) {
    return "language = \"de\"\n" + minimal + tables;
  };
  EXPECT_THAT(of("language = \"en-GB\"\n" + minimal), IsEmpty());
  const UntranslatedTexts all = untranslated_texts(load(german("")));
  EXPECT_EQ(all.keys.size(), all.of);
  EXPECT_THAT(all.keys,
              AllOf(Contains("texts.welcome"), Contains("mark"), Contains("rating"),
                    Not(Contains("texts.loading_keys")), Not(Contains("texts.ready_mark"))));
  EXPECT_THAT(
      of(german("[texts]\nwelcome = \"Willkommen\"\n")),
      ElementsAre(StartsWith(fmt::format(
          "{}:1:12: the language is de, and {} of the {} texts of the screens stay English; "
          "give the protocol its own words for them; --json lists them as untranslated",
          path_.string(), all.of - 1, all.of))));
}

TEST_F(Cautions, FewTextsThatStayEnglishAreListed) {
  std::string tables =
      "[[mark]]\nid = \"a\"\ninstruction = \"Jetzt.\"\n[[rating]]\nid = \"r\"\ntext = \"?\"\n"
      "[[questionnaire]]\nid = \"load\"\nfile = \"nasa-tlx\"\n[texts]\n";
  for (const std::string& key : untranslated_texts(load("language = \"fi\"\n" + minimal)).keys) {
    if (key.starts_with("texts.") && key != "texts.pause") {
      tables += key.substr(6) + " = \"x\"\n";
    }
  }
  EXPECT_THAT(of("language = \"fi\"\n" + minimal + tables),
              ElementsAre(HasSubstr("stay English: texts.pause, questionnaire[0].file; give")));
}

}  // namespace
}  // namespace foveola::study
