#include "analysis/publication/background.h"

#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using study::BackgroundRow;
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
  records.scenes = {"aula"};
  records.methods = {"od", "fv"};
  for (int p = 1; p <= 4; ++p) {
    const std::string code = fmt::format("P{}", p);
    records.sessions.push_back({code, "human", "completed"});
    for (const std::string& method : records.methods) {
      study::TrialRow row;
      row.participant = code;
      row.scene = "aula";
      row.method = method;
      row.outline_s = method == "od" ? 10.0 + p : 10.0;
      records.trials.push_back(row);
    }
  }
  return records;
}

TEST(Background, CorrelatesTheMeanAnswerWithTheSecondsSaved) {
  const AnalysisSet set = select_for_analysis(saving_study());
  // The means of the two answers are 4, 3, 2, 1 for savings of 1, 2, 3, 4 seconds.
  const std::vector<BackgroundRow> answers = {{"P1", "a", 5}, {"P1", "b", 3}, {"P2", "a", 1},
                                              {"P2", "b", 5}, {"P3", "a", 2}, {"P3", "b", 2},
                                              {"P4", "a", 1}, {"P4", "b", 1}};
  const auto rows = correlate_background(set, answers, {{"a", "b"}, false});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].method, "fv");
  EXPECT_EQ(rows[0].participants, 4U);
  EXPECT_DOUBLE_EQ(rows[0].pearson->r, -1.0);
  EXPECT_DOUBLE_EQ(rows[0].spearman->r, -1.0);
  EXPECT_DOUBLE_EQ(rows[0].spearman->p, 2.0 / 24.0);
  EXPECT_EQ(rows[1].mark, Mark::material);
  EXPECT_EQ(rows[1].participants, 0U);
  EXPECT_FALSE(rows[1].pearson);
  EXPECT_FALSE(rows[1].spearman);
}

TEST(Background, AParticipantWithoutEveryAnswerIsLeftOut) {
  const AnalysisSet set = select_for_analysis(saving_study());
  const std::vector<BackgroundRow> answers = {
      {"P1", "a", 5}, {"P2", "a", 1}, {"P2", "b", 5}, {"P3", "a", 2}, {"P3", "b", 2}};
  EXPECT_EQ(correlate_background(set, answers, {{"a", "b"}, false})[0].participants, 2U);
}

TEST(Background, AnAnswerThatIsNoNumberIsNamed) {
  const AnalysisSet set = select_for_analysis(saving_study());
  const std::vector<BackgroundRow> answers = {
      {"P1", "a", std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT(
      [&] {
        (void)correlate_background(set, answers, {{"a"}, false});
      },
      ThrowsMessage<Error>(AllOf(HasSubstr("participant P1"), HasSubstr("question a"))));
}

}  // namespace
}  // namespace foveola::analysis
