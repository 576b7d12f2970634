// The measures of a protocol that the analysis has tables of, and the notes on the others.
#include "study/protocol/analysed_measures.h"

#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

const std::string third_mark = "[[mark]]\nid = \"third\"\ninstruction = \"Now.\"\n";
const std::string comfort =
    "[[rating]]\nid = \"comfort\"\ntext = \"?\"\nkind = \"number\"\nminimum = 0\nmaximum = 100\n";

class AnalysedMeasures : public ProtocolTables {
 protected:
  /// The planned analyses that cannot be done, in one line each, from the file's name on.
  std::vector<std::string> faults(const std::string& tables) const {
    std::vector<std::string> lines;
    for (const Error& fault : unanalysable(load(tables))) {
      lines.push_back(without_folder(fault.what()));
    }
    return lines;
  }

  std::vector<std::string> only_recorded(const std::string& tables) const {
    std::vector<std::string> lines = recorded_only(load(tables));
    std::transform(lines.begin(), lines.end(), lines.begin(),
                   [this](const std::string& line) { return without_folder(line); });
    return lines;
  }

 private:
  std::string without_folder(const std::string& line) const {
    const std::string folder = path_.parent_path().string() + "/";
    return line.starts_with(folder) ? line.substr(folder.size()) : line;
  }
};

TEST_F(AnalysedMeasures, TheDefaultsAreAllAnalysed) {
  EXPECT_THAT(faults(""), IsEmpty());
  EXPECT_THAT(only_recorded(""), IsEmpty());
  EXPECT_THAT(analysed_measures(load("")), ElementsAre("outline", "material", "artifacts"));
}

TEST_F(AnalysedMeasures, ComeOutOfTheProtocolsOfFoveolaButForTheDebrief) {
  for (const char* name : {"demo", "real-scenes", "koskela2018"}) {
    const Protocol protocol = load_protocol(find_protocol(name));
    EXPECT_THAT(unanalysable(protocol), IsEmpty()) << name;
    if (name != std::string("koskela2018")) {
      EXPECT_THAT(recorded_only(protocol), IsEmpty()) << name;
    }
  }
  EXPECT_THAT(recorded_only(load_protocol(find_protocol("koskela2018"))),
              ElementsAre(HasSubstr("the questionnaire debrief")));
}

TEST_F(AnalysedMeasures, ArtifactsHaveFiveWholePointsWithAnyLabels) {
  const std::string rating = "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\n";
  EXPECT_THAT(faults(rating), IsEmpty());
  EXPECT_THAT(faults(rating + "labels = [\"keine\", \"überall\"]\n"), IsEmpty());
  EXPECT_THAT(faults(rating + "labels = [\"a\", \"b\", \"c\", \"d\", \"e\"]\n"), IsEmpty());
  EXPECT_THAT(faults(rating + "minimum = 0\nmaximum = 100\n"),
              ElementsAre(AllOf(StartsWith("p.toml:9:11: the rating artifacts is a scale from 0 to "
                                           "100, and the analysis reads whole points from 1 to 5"),
                                HasSubstr("; make it a scale from 1 to 5"))));
  EXPECT_THAT(faults(rating + "maximum = 7\n"),
              ElementsAre(StartsWith("p.toml:8:11: the rating artifacts is a scale from 1 to 7")));
  EXPECT_THAT(faults(rating + "minimum = 0\n"),
              ElementsAre(StartsWith("p.toml:8:11: the rating artifacts is a scale from 0 to 5")));
  EXPECT_THAT(faults(rating + "kind = \"number\"\nminimum = 1\nmaximum = 5\n"),
              ElementsAre(StartsWith("p.toml:8:8: the rating artifacts is a number from 1 to 5")));
  EXPECT_THAT(faults(rating + "kind = \"choice\"\noptions = [{ label = \"no\", value = 0 }, "
                              "{ label = \"a bit\", value = 0.5 }]\n"),
              ElementsAre(StartsWith("p.toml:8:8: the rating artifacts is a choice of 2 options")));
  EXPECT_THAT(faults(rating + "kind = \"text\"\n"),
              ElementsAre(StartsWith("p.toml:8:8: the rating artifacts is answered in words")));
}

TEST_F(AnalysedMeasures, ComparisonsAndEquivalencesArePlannedOfWhatIsAnalysed) {
  const std::string plan =
      "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n"
      "[[analysis.primary]]\nmeasure = \"third\"\nmethod = \"fv\"\n"
      "[[analysis.primary]]\nmeasure = \"comfort\"\nmethod = \"fv\"\n"
      "[analysis.equivalence_margins]\noutline = 1.2\ncomfort = 5\n";
  const std::string outline = "[[mark]]\nid = \"outline\"\ninstruction = \"Now.\"\n";
  EXPECT_THAT(
      faults(outline + third_mark + comfort + plan),
      ElementsAre(AllOf(StartsWith("p.toml:21:11: a comparison of third is planned, of which the "
                                   "analysis has no tables; plan only for outline, and")),
                  StartsWith("p.toml:24:11: a comparison of comfort is planned"),
                  StartsWith("p.toml:28:11: an equivalence of comfort is planned")));
  EXPECT_THAT(
      faults(third_mark + comfort + "[[analysis.primary]]\nmeasure = \"third\"\nmethod = \"fv\"\n"),
      ElementsAre(HasSubstr("; leave it out")));
}

TEST_F(AnalysedMeasures, AMarkIsNoRatingOfTheSameName) {
  const std::string swapped =
      "[[mark]]\nid = \"artifacts\"\ninstruction = \"Now.\"\n"
      "[[rating]]\nid = \"outline\"\ntext = \"?\"\n";
  EXPECT_THAT(faults(swapped + "[[analysis.primary]]\nmeasure = \"outline\"\nmethod = \"fv\"\n"),
              SizeIs(1));
  EXPECT_THAT(faults(swapped + "[[analysis.primary]]\nmeasure = \"artifacts\"\nmethod = \"fv\"\n"),
              SizeIs(1));
  EXPECT_THAT(only_recorded(swapped), SizeIs(2));
}

TEST_F(AnalysedMeasures, WhatComesOutInTheRecordOnlyIsNamedWithItsPlace) {
  const std::string background =
      "[[questionnaire]]\nid = \"background\"\ntitle = \"You\"\n"
      "[[questionnaire.question]]\nid = \"age\"\ntext = \"?\"\n"
      "[[questionnaire.question]]\nid = \"work\"\ntext = \"?\"\nkind = \"text\"\n"
      "[[questionnaire.question]]\nid = \"hand\"\ntext = \"?\"\nkind = \"choice\"\n"
      "options = [{ label = \"left\" }, { label = \"right\" }]\n"
      "[[questionnaire.question]]\nid = \"gender\"\ntext = \"?\"\nkind = \"choice\"\n"
      "options = [{ label = \"female\", value = 5 }, { label = \"another\" }]\n";
  const std::string load = "[[questionnaire]]\nid = \"load\"\nfile = \"nasa-tlx\"\n";
  EXPECT_THAT(
      only_recorded(third_mark + comfort + background + load + "[catch_trials]\ncount = 1\n"),
      ElementsAre(
          "p.toml:6:6: the analysis has no tables of the mark third, which comes out in the record "
          "only",
          StartsWith("p.toml:9:6: the analysis has no tables of the rating comfort"),
          StartsWith("p.toml:21:6: the analysis has no tables of what is answered in words to "
                     "background.work"),
          StartsWith("p.toml:25:6: the analysis has no tables of what is answered in words to "
                     "background.hand"),
          StartsWith("p.toml:35:6: the analysis has no tables of the questionnaire load"),
          StartsWith("p.toml:38:9: the analysis has no tables of what is marked in catch trials")));
}

TEST_F(AnalysedMeasures, QuestionsOfAFileAreWhereTheFileIsNamed) {
  folder_.write("you.toml",
                "title = \"You\"\n[[question]]\nid = \"work\"\ntext = \"?\"\nkind = \"text\"\n");
  EXPECT_THAT(only_recorded("[[questionnaire]]\nid = \"background\"\nfile = \"./you.toml\"\n"),
              ElementsAre(StartsWith("p.toml:7:8: ")));
}

}  // namespace
}  // namespace foveola::study
