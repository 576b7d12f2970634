#include "analysis/koskela2018/profile.h"

#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

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

// The same ids in a protocol of one's own: its marks need not mean what the paper's do.
TEST(Profile, IsNotOfSomebodysOwnStudy) {
  study::StudyRecords records = complete_study(1);
  records.protocol.name = "bg";
  const Dataset own = select_for_analysis(records);
  EXPECT_FALSE(measures_what_was_published(own));
  EXPECT_EQ(meaning_of_mark(own, "outline"), "");
  EXPECT_EQ(moment_of(own, own.measures[outline_index]), "the mark outline");
  EXPECT_THAT(reason_for_mark(own, own.measures[outline_index]),
              AllOf(StartsWith("“"), EndsWith(" (outline)")));
}

TEST(Profile, NamesTheMomentsOfItsMarksAndCallsOthersByTheirIds) {
  const Dataset set = select_for_analysis(complete_study(1));
  EXPECT_EQ(moment_of(set, set.measures[outline_index]), "the outline was visible");
  Measure third = set.measures[outline_index];
  third.question.id = "third";
  EXPECT_EQ(moment_of(set, third), "the mark third");
  EXPECT_EQ(meaning_of_mark(set, "third"), "");
}

}  // namespace
}  // namespace foveola::analysis
