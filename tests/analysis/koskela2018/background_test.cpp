#include "analysis/koskela2018/background.h"

#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/study_tables.h"
#include "renderer/base/error.h"
#include "study/protocol/read_procedure.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

// Koskela et al. 2018, section 5.1: "The questions used in the calculation were questions 3 and 4."
TEST(Background, ThePublishedQuestionsAreChosenWhereBothWereAsked) {
  const BackgroundScale scale = choose_background_scale(
      {{"P1", "virtual_reality", 2}, {"P1", "offline_rendering", 5}, {"P1", "graphics_3d", 4}});
  EXPECT_TRUE(scale.as_published);
  EXPECT_THAT(scale.questions, ElementsAre("graphics_3d", "offline_rendering"));
}

TEST(Background, ElseEveryFivePointQuestionCounts) {
  const BackgroundScale scale = choose_background_scale({{"P1", "virtual_reality", 2},
                                                         {"P1", "offline_rendering", 3},
                                                         {"P1", "age", 4},
                                                         {"P1", "gender", 5},
                                                         {"P1", "hours", 2.5},
                                                         {"P2", "age", 31},
                                                         {"P2", "graphics", 1}});
  EXPECT_FALSE(scale.as_published);
  EXPECT_THAT(scale.questions, ElementsAre("graphics", "offline_rendering", "virtual_reality"));
}

TEST(Background, WithoutQuestionsThereIsNoScale) {
  EXPECT_THAT(choose_background_scale({}).questions, IsEmpty());
}

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
  const auto rows = correlate_background(set, answers, {{"a", "b"}, false});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].quantity, TimeSaved::log_ratio);
  EXPECT_NEAR(rows[0].pearson->r, -0.999355114, 1e-9);  // R: cor(4:1, log(1.1 + 0:3 / 10))
  EXPECT_DOUBLE_EQ(rows[0].spearman->r, -1.0);
  EXPECT_EQ(rows[2].quantity, TimeSaved::seconds_saved);
  EXPECT_DOUBLE_EQ(rows[2].pearson->r, -1.0);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(rows[i].method, "fv");
    EXPECT_EQ(rows[i].participants, 4U);
    EXPECT_DOUBLE_EQ(rows[i].spearman->p, 2.0 / 24.0);
    EXPECT_EQ(rows[i].mark, "outline");
  }
  EXPECT_EQ(rows[1].mark, "material");
  EXPECT_EQ(rows[1].participants, 0U);
  EXPECT_FALSE(rows[1].pearson);
  EXPECT_FALSE(rows[1].spearman);
}

TEST(Background, AParticipantWithoutEveryAnswerIsLeftOut) {
  const Dataset set = select_for_analysis(saving_study());
  const std::vector<BackgroundAnswer> answers = {
      {"P1", "a", 5}, {"P2", "a", 1}, {"P2", "b", 5}, {"P3", "a", 2}, {"P3", "b", 2}};
  EXPECT_EQ(correlate_background(set, answers, {{"a", "b"}, false})[0].participants, 2U);
}

TEST(Background, AnAnswerThatIsNoNumberIsNamed) {
  const Dataset set = select_for_analysis(saving_study());
  const std::vector<BackgroundAnswer> answers = {
      {"P1", "a", std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT([&] { (void)correlate_background(set, answers, {{"a"}, false}); },
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
  Dataset set = select_for_analysis(records);
  const Background background = analyse_background(background_answers(records), set);
  EXPECT_TRUE(background.scale.as_published);
  ASSERT_EQ(background.correlations.size(), 8U);
  for (const BackgroundCorrelation& row : background.correlations) {
    const std::string key =
        row.mark + "." + row.method + "." + (row.quantity == TimeSaved::log_ratio ? "log_" : "");
    ASSERT_TRUE(row.pearson);
    EXPECT_EQ(row.participants, 8U);
    EXPECT_GOLDEN(row.pearson->r, golden.at(key + "r"));
    EXPECT_GOLDEN(row.pearson->p, golden.at(key + "p"));
    EXPECT_GOLDEN(row.pearson->interval->low, golden.at(key + "r_low"));
    EXPECT_GOLDEN(row.pearson->interval->high, golden.at(key + "r_high"));
  }
}

TEST(Background, DoesNotDependOnTheUnitOfTime) {
  study::StudyRecords records = golden_study_records();
  const auto correlations = [&] {
    Dataset set = select_for_analysis(records);
    return analyse_background(background_answers(records), set).correlations;
  };
  const std::vector<BackgroundCorrelation> in_seconds = correlations();
  for (const char* mark : {"outline", "material"}) {
    change_values(records, mark, [](study::Value& value) { value.number *= 1000.0; });
  }
  const std::vector<BackgroundCorrelation> in_milliseconds = correlations();
  for (std::size_t i = 0; i < in_seconds.size(); ++i) {
    EXPECT_GOLDEN(in_milliseconds[i].pearson->p, in_seconds[i].pearson->p);
  }
}

TEST(Background, OneParticipantOrOneMethodHasNoCorrelation) {
  study::StudyRecords records = complete_study(1);
  Dataset alone = select_for_analysis(records);
  EXPECT_FALSE(analyse_background(background_answers(records), alone).correlations[0].pearson);
  records.methods = {"od"};
  keep_trials(records, [](const study::TrialRow& row) { return row.method == 0; });
  Dataset one_method = select_for_analysis(records);
  EXPECT_THAT(analyse_background(background_answers(records), one_method).correlations, IsEmpty());
}

TEST(Background, WhoDidNotAnswerAllIsListed) {
  study::StudyRecords records = complete_study(2);
  records.answers.pop_back();
  Dataset set = select_for_analysis(records);
  (void)analyse_background(background_answers(records), set);
  ASSERT_EQ(set.exclusions.size(), 1U);
  EXPECT_EQ(set.exclusions[0].participant, "P2");
  EXPECT_EQ(set.exclusions[0].measure, "background");
}

}  // namespace
}  // namespace foveola::analysis
