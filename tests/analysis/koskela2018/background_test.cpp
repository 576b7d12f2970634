#include "analysis/koskela2018/background.h"

#include <limits>

#include <fmt/format.h>

#include "analysis/dataset/study_tables.h"
#include "renderer/base/error.h"
#include "study/protocol/reading/read_procedure.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t fv = 1;  ///< Its place in the saving study.

/// Participants P1 to P4 save 1 to 4 seconds in the one scene of this study.
study::StudyRecords saving_study() {
  study::StudyRecords records;
  records.measures = study::trial_measures(study::published_marks(), study::published_ratings());
  records.scenes = {"aula"};
  records.methods = {"od", "fv"};
  records.words = {""};
  for (std::uint16_t p = 1; p <= 4; ++p) {
    records.sessions.push_back({fmt::format("P{}", p), "human", "completed", {}, {}});
    for (std::uint16_t method = 0; method < 2; ++method) {
      records.add_trial({.session = p - 1U, .method = method, .attempt = 1},
                        {measured(method == 0 ? 10.0 + p : 10.0), {}, {}});
    }
  }
  return records;
}

TEST(Background, CorrelatesTheMeanAnswerWithTheSpeedUp) {
  const Dataset set = select_for_analysis(saving_study());
  // The means of the two answers are 4, 3, 2, 1 for savings of 1, 2, 3, 4 seconds.
  const std::vector<BackgroundAnswer> answers = {{"P1", "a", 5}, {"P1", "b", 3}, {"P2", "a", 1},
                                                 {"P2", "b", 5}, {"P3", "a", 2}, {"P3", "b", 2},
                                                 {"P4", "a", 1}, {"P4", "b", 1}};
  const BackgroundCorrelation ratio =
      correlate_background(set, answers, {"a", "b"}, TimeSaved::log_ratio, outline_index, fv);
  EXPECT_EQ(ratio.quantity, TimeSaved::log_ratio);
  EXPECT_NEAR(ratio.pearson->r, -0.999355114, 1e-9);  // R: cor(4:1, log(1.1 + 0:3 / 10))
  EXPECT_DOUBLE_EQ(ratio.spearman->r, -1.0);
  EXPECT_DOUBLE_EQ(ratio.spearman->p, 2.0 / 24.0);
  EXPECT_EQ(ratio.method, "fv");
  EXPECT_EQ(ratio.mark, "outline");
  EXPECT_EQ(ratio.participants, 4U);
  EXPECT_DOUBLE_EQ(
      correlate_background(set, answers, {"a", "b"}, TimeSaved::seconds_saved, outline_index, fv)
          .pearson->r,
      -1.0);
  const BackgroundCorrelation material =
      correlate_background(set, answers, {"a", "b"}, TimeSaved::log_ratio, material_index, fv);
  EXPECT_EQ(material.participants, 0U);
  EXPECT_FALSE(material.pearson || material.spearman);
}

TEST(Background, AParticipantWithoutEveryAnswerIsLeftOut) {
  const Dataset set = select_for_analysis(saving_study());
  const std::vector<BackgroundAnswer> answers = {
      {"P1", "a", 5}, {"P2", "a", 1}, {"P2", "b", 5}, {"P3", "a", 2}, {"P3", "b", 2}};
  EXPECT_EQ(correlate_background(set, answers, {"a", "b"}, TimeSaved::log_ratio, outline_index, fv)
                .participants,
            2U);
}

TEST(Background, AnAnswerThatIsNoNumberIsNamed) {
  const Dataset set = select_for_analysis(saving_study());
  const std::vector<BackgroundAnswer> answers = {
      {"P1", "a", std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT(
      [&] {
        (void)correlate_background(set, answers, {"a"}, TimeSaved::log_ratio, outline_index, fv);
      },
      ThrowsMessage<Error>(AllOf(HasSubstr("participant P1"), HasSubstr("question a"))));
}

TEST(Background, IsWhatWasAnsweredInNumbersToTheQuestionnaireOfThatId) {
  study::StudyRecords records = complete_study(1);
  add_answer(records, "P1", "tlx", "mental", 7.0);
  add_answer_in_words(records, "P1", "background", "work", "painter");
  const std::vector<BackgroundAnswer> answers = background_answers(records);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].participant, "P1");
  EXPECT_EQ(answers[0].question, "offline_rendering");
  EXPECT_EQ(answers[1].question, "graphics_3d");
}

TEST(Background, CorrelationsOfTheGoldenStudyAreThoseOfR) {
  const auto golden = golden_study();
  const study::StudyRecords records = golden_study_records();
  const Dataset set = select_for_analysis(records);
  for (const TimeSaved quantity : {TimeSaved::log_ratio, TimeSaved::seconds_saved}) {
    for (const std::size_t mark : {outline_index, material_index}) {
      for (const std::size_t method : {1U, 2U}) {
        const BackgroundCorrelation row =
            correlate_background(set, background_answers(records),
                                 {"graphics_3d", "offline_rendering"}, quantity, mark, method);
        const std::string key =
            row.mark + "." + row.method + "." + (quantity == TimeSaved::log_ratio ? "log_" : "");
        ASSERT_TRUE(row.pearson);
        EXPECT_EQ(row.participants, 8U);
        EXPECT_GOLDEN(row.pearson->r, golden.at(key + "r"));
        EXPECT_GOLDEN(row.pearson->p, golden.at(key + "p"));
        EXPECT_GOLDEN(row.pearson->interval->low, golden.at(key + "r_low"));
        EXPECT_GOLDEN(row.pearson->interval->high, golden.at(key + "r_high"));
      }
    }
  }
}

Background background_of(const study::StudyRecords& records) {
  Dataset set = select_for_analysis(records);
  return analyse_background(background_answers(records), records.protocol.analysis, set);
}

study::StudyRecords planned_golden_study() {
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {
      {"artifacts", "fv", "od"}, {"material", "fv", "vp"}, {"material", "od", "fv"}};
  return records;
}

// Of 16 correlations one in four studies had one with P below 0.05 by chance.
TEST(Background, OneCorrelationIsTestedTheOneThatThePlanStates) {
  const Background background = background_of(planned_golden_study());
  EXPECT_THAT(background.scale, ElementsAre("graphics_3d", "offline_rendering"));
  EXPECT_EQ(background.correlation->mark, "material");
  EXPECT_EQ(background.correlation->method, "fv");
  EXPECT_EQ(background.correlation->quantity, TimeSaved::log_ratio);
  EXPECT_GOLDEN(background.correlation->pearson->p, golden_study().at("material.fv.log_p"));
  EXPECT_EQ(background.answers.size(), 3U);
  EXPECT_FALSE(background_of(golden_study_records()).correlation) << "nothing is planned";
}

// A scale of 1 to 7, a hand as 1 or 2 and a number of children were averaged, since the answers
// looked like a scale of five points.
TEST(Background, WithoutAStatedScaleNothingIsCorrelated) {
  study::StudyRecords records = planned_golden_study();
  records.protocol.analysis.background.clear();
  for (int i = 1; i <= 8; ++i) {
    const std::string code = fmt::format("P0{}", i);
    add_answer(records, code, "background", "handedness", 1.0 + i % 2);
    add_answer(records, code, "background", "children", 1.0 + i % 3);
  }
  const Background background = background_of(records);
  EXPECT_THAT(background.scale, IsEmpty());
  EXPECT_FALSE(background.correlation);
  EXPECT_EQ(background.answers.size(), 5U);
}

TEST(Background, DoesNotDependOnTheUnitOfTime) {
  study::StudyRecords records = planned_golden_study();
  const double in_seconds = background_of(records).correlation->pearson->p;
  change_values(records, "material", [](study::Value& value) { value.number *= 1000.0; });
  EXPECT_GOLDEN(background_of(records).correlation->pearson->p, in_seconds);
}

TEST(Background, OneParticipantHasNoCorrelationCoefficient) {
  study::StudyRecords records = complete_study(1);
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  EXPECT_FALSE(background_of(records).correlation->pearson);
}

TEST(Background, WhoDidNotAnswerAllIsListed) {
  study::StudyRecords records = complete_study(2);
  records.answers.pop_back();
  Dataset set = select_for_analysis(records);
  (void)analyse_background(background_answers(records), records.protocol.analysis, set);
  ASSERT_EQ(set.exclusions.size(), 1U);
  EXPECT_EQ(set.exclusions[0].participant, "P2");
  EXPECT_EQ(set.exclusions[0].measure, "background");
}

}  // namespace
}  // namespace foveola::analysis
