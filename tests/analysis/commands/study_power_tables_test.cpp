#include "analysis/commands/study_power_tables.h"

#include <nlohmann/json.hpp>

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// Results of 100 studies each, with so many of them significant.
StudyPower point(std::size_t participants, std::size_t first, std::size_t second, std::size_t all) {
  return {
      .participants = participants,
      .studies = 100,
      .comparisons =
          {{.significant = first, .analyses = {{AnalysisKind::crossed_model, 100}}, .stand_ins = 0},
           {.significant = second,
            .analyses = {{AnalysisKind::participant_t, 40}, {AnalysisKind::crossed_model, 60}},
            .stand_ins = 40}},
      .all_significant = all,
      .analysed = 0.9 * static_cast<double>(participants),
      .censored = {{0.0, 0.0, 0.0}, {0.125, 0.0, 0.03}, {0.0, 0.0, 0.0}}};
}

StudyPowerReport report_with(const std::vector<StudyPower>& curve) {
  StudyPowerReport report;
  report.expected = example_study();
  report.expected.protocol.analysis.primary = {{"outline", "fv", "od"}, {"comfort", "vp", "od"}};
  report.expected.shifts[1][1] = 8.0;
  report.expected.withdrawals = 0.1;
  report.studies = 100;
  report.curve = curve;
  return report;
}

TEST(StudyPowerTables, WhatIsExpectedIsPrinted) {
  const std::string text = expectations_text(report_with({}));
  for (const char* part : {"5 scenes (random), 3 methods", "2 planned comparisons at 0.05",
                           "15 s with od; vp 32 %, fv 10 % of that", "comfort", "vp +8",
                           "withdrawals   10 %", "varies by 0.25 of its mean (--mark-variation)",
                           "material with outline by 0.90", "ratings depend on no time"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(StudyPowerTables, FewestParticipantsOfEachAndOfAllTogether) {
  const StudyPowerReport report =
      report_with({point(8, 80, 20, 15), point(10, 92, 50, 48), point(16, 95, 91, 88)});
  const std::string text = study_power_text(report);
  EXPECT_THAT(text, HasSubstr("outline, fv/od: 10\n"));
  EXPECT_THAT(text, HasSubstr("comfort, vp/od: 16\n"));
  EXPECT_THAT(text, HasSubstr("all together: more than 16, or out of reach\n"));
  EXPECT_THAT(text, HasSubstr("try more with --scenes"));
  EXPECT_THAT(text, HasSubstr("92.0 [84.8,  96.5]"));  // Clopper and Pearson's, of 92 in 100
  EXPECT_THAT(text, HasSubstr("material, od 12.5 %; material, fv 3.0 %"));
  EXPECT_THAT(text, HasSubstr("comfort, vp/od: crossed mixed model 60.0 %, paired t over "
                              "participants 40.0 % (in 40.0 % in place of the planned one"));
  const nlohmann::json json = nlohmann::json::parse(study_power_json(report));
  EXPECT_EQ(json["fewest_participants"], (nlohmann::json{10, 16}));
  EXPECT_TRUE(json["fewest_participants_all"].is_null());
  EXPECT_EQ(json["curve"][1]["comparisons"][0]["power"], 0.92);
  EXPECT_EQ(json["curve"][2]["censored_part"]["material"]["od"], 0.125);
  EXPECT_EQ(json["participant_kind"], "simulated");
}

TEST(StudyPowerTables, OneNumberOfParticipantsHasNoFewest) {
  EXPECT_THAT(study_power_text(report_with({point(16, 95, 91, 88)})), Not(HasSubstr("Fewest")));
}

}  // namespace
}  // namespace foveola::analysis
