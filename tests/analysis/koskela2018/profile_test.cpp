#include "analysis/koskela2018/profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

TEST(Profile, IsOfStudiesThatMeasureWhatWasPublished) {
  study::StudyRecords records = complete_study(1);
  EXPECT_TRUE(measures_what_was_published(select_for_analysis(records)));
  records.measures[artifacts_index].question.labels = {"keine", "alle"};
  EXPECT_TRUE(measures_what_was_published(select_for_analysis(records)));
}

TEST(Profile, IsNotOfOtherMarksRatingsOrScales) {
  study::StudyRecords records = complete_study(1);
  records.measures[artifacts_index].question.maximum = 7;
  EXPECT_FALSE(measures_what_was_published(select_for_analysis(records)));
  records = complete_study(1);
  records.measures[material_index].question.id = "third";
  EXPECT_FALSE(measures_what_was_published(select_for_analysis(records)));
  records = complete_study(1);
  records.measures[artifacts_index].question.id = "comfort";
  EXPECT_FALSE(measures_what_was_published(select_for_analysis(records)));
}

TEST(Profile, NamesTheMomentsOfItsMarksAndCallsOthersByTheirIds) {
  const std::vector<Measure> measures = complete_study(1).measures;
  EXPECT_EQ(moment_of(measures[outline_index]), "the outline was visible");
  Measure third = measures[outline_index];
  third.question.id = "third";
  EXPECT_EQ(moment_of(third), "the mark third");
  EXPECT_EQ(meaning_of_mark("third"), "");
}

}  // namespace
}  // namespace foveola::analysis
