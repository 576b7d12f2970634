#include "analysis/publication/report/methods_paragraph.h"

#include <filesystem>

#include "study/protocol/reading/read_procedure.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::string paragraph(const study::StudyRecords& records,
                      const study::DataQualityRecords& quality = {}) {
  const StudyTables tables = tabulate_study(records);
  return methods_paragraph(tables, compare_methods(tables.set, records.protocol.analysis), records,
                           quality);
}

TEST(MethodsParagraph, SaysWhatTheProtocolSays) {
  study::StudyRecords records = complete_study(4);
  records.protocol = study::load_protocol(std::filesystem::path(FOVEOLA_DATA_DIR).parent_path() /
                                          "protocols" / "koskela2018.toml");
  records.display_profile = "fove0";
  const std::string text = paragraph(records);
  EXPECT_THAT(text, HasSubstr("4 participants saw 2 scenes (aula, barn)"));
  EXPECT_THAT(text,
              HasSubstr("The order of scenes was random, that of methods within a scene random"));
  EXPECT_THAT(text, HasSubstr("4096 × 2048 pixels"));
  EXPECT_THAT(text, HasSubstr("profile fove0"));
  EXPECT_THAT(text, HasSubstr("time-out of a mark was 900 s"));
  EXPECT_THAT(text, HasSubstr("2 comparisons were planned"));
}

TEST(MethodsParagraph, SaysWhereTheGazeCameFromAndWhereSessionsDiffer) {
  study::StudyRecords records = complete_study(2);
  records.programs = {{"P1", {"foveola 0.2.0"}}, {"P2", {"foveola 0.2.0"}}};
  study::DataQualityRecords quality;
  quality.gaze = {{.participant = "P1", .tracker = "pointer"},
                  {.participant = "P2", .tracker = "pointer"}};
  value_of(records, "P2", "barn", "fv", "artifacts") = {};
  EXPECT_THAT(paragraph(records, quality),
              AllOf(HasSubstr("Gaze came from the mouse pointer in place of an eye."),
                    HasSubstr("Sessions were run by foveola 0.2.0."),
                    HasSubstr("Of 12 ratings 1 was missing.")));
  quality.gaze[1].tracker = "fove0";
  records.programs[1].programs = {"foveola 0.1.0"};
  EXPECT_THAT(paragraph(records, quality),
              AllOf(HasSubstr("different sources: the eye tracker of profile fove0 (P2); the mouse "
                              "pointer in place of an eye (P1)."),
                    HasSubstr("different programs: foveola 0.2.0 in 1 session; foveola 0.1.0 in 1 "
                              "session.")));
}

TEST(MethodsParagraph, SaysWhatSessionsRanOnAsTheyRecordedIt) {
  const study::StudyRecords records = complete_study(2);
  const std::string devices =
      R"({"display": {"framebuffer": [1280, 720], "horizontal_fov_deg": 48.0,
          "distance_mm": 600, "refresh_rate_hz": 60.0}, "machine": {"processor": "A"},
          "preflight": {"speeds": [{"samples_per_second": 1e6}]}})";
  study::DataQualityRecords quality;
  quality.setups = {{"P1", "human", {devices}}, {"P2", "human", {devices}}};
  EXPECT_THAT(paragraph(records, quality),
              HasSubstr(" Sessions ran with pixels 1280 x 720; horizontal degrees 48; viewing "
                        "distance in mm 600; frame rate in Hz 60; processor A."));
  quality.setups[1].devices = {R"({"machine": {"processor": "B"}})"};
  EXPECT_THAT(paragraph(records, quality), HasSubstr("; processor (A in P1; B in P2)."));
  // Nobody saw what a simulation ran on.
  quality.setups = {{"P1", "simulated", {devices}}};
  EXPECT_THAT(paragraph(records, quality), Not(HasSubstr("Sessions ran with")));
}

TEST(MethodsParagraph, LeavesOutWhatItDoesNotSay) {
  const std::string text = paragraph(complete_study(1));
  EXPECT_THAT(text, AllOf(HasSubstr("1 participant saw"), HasSubstr("No comparison was planned")));
  for (const char* words : {"of profile", "filled in", "catch trial", "practice"}) {
    EXPECT_THAT(text, Not(HasSubstr(words)));
  }
}

TEST(MethodsParagraph, TellsAllAnalysesThatWereDoneAndNoOthers) {
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("As sensitivity analyses there are paired t tests"),
                    HasSubstr("(BCa)"), HasSubstr("Friedman"), Not(HasSubstr("trends over trials")),
                    HasSubstr("without each participant in turn"), HasSubstr("right-censored and"),
                    Not(HasSubstr("Equivalence"))));
  records.protocol.analysis.equivalence_margins = {{"outline", 1.25}};
  EXPECT_THAT(paragraph(records),
              HasSubstr("two one-sided tests of the primary analysis with 90 % intervals"));
  EXPECT_THAT(paragraph(complete_study(1)),
              AllOf(Not(HasSubstr("sensitivity")), Not(HasSubstr("right-censored and"))));
}

TEST(MethodsParagraph, SaysWhatElseWasDone) {
  study::StudyRecords records = complete_study(2);
  records.protocol.practice = {{"aula", "od"}};
  records.protocol.catch_trials.count = 3;
  study::Questionnaire form;
  form.id = "load";
  form.source = "Hart 2006";
  records.protocol.questionnaires = {form};
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("One practice trial came before."), HasSubstr("were 3 catch trials"),
                    HasSubstr("They filled in load (Hart 2006).")));
}

TEST(MethodsParagraph, SaysHowDataWereSimulated) {
  study::StudyRecords records = of_kind(complete_study(2), "simulated");
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("Simulated data:"), HasSubstr("2 simulated participants saw"),
                    Not(AnyOf(HasSubstr("predicted"), HasSubstr("scaled")))));
  records.simulation = study::SimulationFacts{.scale = 36.0, .predicted = true, .injected = ""};
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("not rendered but predicted"), HasSubstr("scaled down by 36.")));
  records.simulation = study::SimulationFacts{.scale = 1.0, .injected = "faster:fv:2"};
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("injected effects (faster:fv:2)"), Not(HasSubstr("scaled"))));
  records.simulation = study::SimulationFacts{.samples_per_second = 8e5, .injected = ""};
  EXPECT_THAT(paragraph(records),
              HasSubstr("traced 800000 samples per second, unlike the protocol's"));
  records.simulation = study::SimulationFacts{.injected = "", .whole_participants = 3};
  EXPECT_THAT(paragraph(records), HasSubstr("They are a part of a study of 3 participants."));
}

TEST(MethodsParagraph, SaysWhatWasMarkedAndRatedInTheProtocolsWords) {
  study::StudyRecords records = complete_study(2);
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("marked when the outline of a chosen object could be judged and "
                              "when its material could be judged; then they rated “"),
                    HasSubstr("(artifacts: 1 none to 5 not discernible at all)")));
  records.measures = study::trial_measures(
      {{"third", "Now it is sharp.", ""}, {"material", "It is wood.", ""}},
      {{.id = "comfort", .text = "Comfortable?", .labels = {"a", "b", "c", "d", "e"}}});
  EXPECT_THAT(
      paragraph(records),
      AllOf(HasSubstr("marked when “Now it is sharp.” (third) and when “It is wood.” (material)"),
            HasSubstr("then they rated “Comfortable?” (comfort: 1 (a), 2 (b), 3 (c), 4 "
                      "(d), 5 (e))."),
            Not(HasSubstr("artifacts"))));
}

TEST(MethodsParagraph, SaysOfWhichPlannedComparisonsThereIsNoP) {
  study::StudyRecords records = complete_study(2);
  records.protocol.analysis.primary = {{"outline", "fv", "od"}, {"comfort", "fv", "od"}};
  EXPECT_THAT(paragraph(records),
              AllOf(HasSubstr("2 comparisons were planned"),
                    HasSubstr("1 of those planned had no P-value and counts as not significant")));
}

}  // namespace
}  // namespace foveola::analysis
