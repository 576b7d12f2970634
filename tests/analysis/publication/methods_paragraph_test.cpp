#include "analysis/publication/methods_paragraph.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/publication/analysis_plan.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

std::string paragraph(const study::StudyRecords& records, const std::string& protocol) {
  const StudyTables tables = tabulate_study(records);
  return methods_paragraph(tables, compare_methods(tables.set, plan_of(protocol)), protocol);
}

TEST(MethodsParagraph, SaysWhatTheProtocolSays) {
  const std::string text =
      paragraph(complete_study(4), read_file(std::filesystem::path(FOVEOLA_DATA_DIR).parent_path() /
                                             "protocols" / "koskela2018.toml"));
  EXPECT_THAT(text, HasSubstr("4 participants saw 2 scenes (aula, barn)"));
  EXPECT_THAT(text,
              HasSubstr("The order of scenes was random, that of methods within a scene random"));
  EXPECT_THAT(text, HasSubstr("4096 × 2048 pixels"));
  EXPECT_THAT(text, HasSubstr("profile fove0"));
  EXPECT_THAT(text, HasSubstr("time-out of a mark was 180 s"));
  EXPECT_THAT(text, HasSubstr("2 comparisons were planned"));
}

TEST(MethodsParagraph, LeavesOutWhatItDoesNotSay) {
  const std::string text = paragraph(complete_study(1), "");
  EXPECT_THAT(text, HasSubstr("1 participant saw"));
  EXPECT_THAT(text, Not(HasSubstr("order of scenes")));
  EXPECT_THAT(text, Not(HasSubstr("pixels")));
  EXPECT_THAT(text, HasSubstr("No comparison was planned"));
}

TEST(MethodsParagraph, CallsSimulatedDataSo) {
  study::StudyRecords records = complete_study(2);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const std::string text = paragraph(records, "");
  EXPECT_THAT(text, HasSubstr("Simulated data:"));
  EXPECT_THAT(text, HasSubstr("2 simulated participants saw"));
}

TEST(MethodsParagraph, SaysHowDataWereSimulated) {
  study::StudyRecords records = complete_study(2);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  EXPECT_THAT(paragraph(records, ""), Not(AnyOf(HasSubstr("predicted"), HasSubstr("scaled"))));
  records.simulation = study::SimulationFacts{.scale = 36.0, .predicted = true, .injected = ""};
  EXPECT_THAT(paragraph(records, ""),
              AllOf(HasSubstr("not rendered but predicted"), HasSubstr("scaled down by 36.")));
  records.simulation = study::SimulationFacts{.scale = 1.0, .injected = "faster:fv:2"};
  EXPECT_THAT(paragraph(records, ""),
              AllOf(HasSubstr("injected effects (faster:fv:2)"), Not(HasSubstr("scaled"))));
}

/// The methods paragraph of a study by this protocol.
std::string paragraph_of(const std::string& protocol) {
  study::StudyRecords records = complete_study(2);
  records.protocol_text = protocol;
  return paragraph(records, protocol);
}

TEST(MethodsParagraph, SaysWhatWasMarkedAndRatedInTheProtocolsWords) {
  EXPECT_THAT(paragraph_of(""),
              HasSubstr("marked when the outline of a chosen object and when its material could be "
                        "judged; then they rated artifacts in other areas from 1 (none) to 5 (not "
                        "discernible at all)."));
  EXPECT_THAT(
      paragraph_of("[[mark]]\nid = \"material\"\ninstruction = \"Now.\"\n"
                   "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\n"
                   "labels = [\"a\", \"b\", \"c\", \"d\", \"e\"]\n"),
      HasSubstr("marked when the material of a chosen object could be judged; then they rated "
                "artifacts in other areas as 1 (a), 2 (b), 3 (c), 4 (d), 5 (e)."));
  EXPECT_THAT(paragraph_of("[[mark]]\nid = \"third\"\ninstruction = \"Now.\"\n"
                           "[[rating]]\nid = \"comfort\"\ntext = \"?\"\n"),
              AllOf(HasSubstr("of progressive path tracing. Other marks and ratings "
                              "(third, comfort) are not analysed here."),
                    Not(HasSubstr("rated artifacts"))));
}

TEST(MethodsParagraph, SaysOfWhichPlannedComparisonsThereIsNothing) {
  const std::string text = paragraph_of(
      "methods = [\"od\", \"fv\"]\n[analysis]\nprimary = [{ measure = \"outline\", "
      "method = \"fv\" }, { measure = \"comfort\", method = \"fv\" }]\n");
  EXPECT_THAT(text, AllOf(HasSubstr("2 comparisons were planned"),
                          HasSubstr("1 of those planned is not analysed here")));
}

TEST(MethodsParagraph, AProtocolThatIsNoTomlIsAnError) {
  EXPECT_THROW((void)paragraph(complete_study(2), "name = "), Error);
}

}  // namespace
}  // namespace foveola::analysis
