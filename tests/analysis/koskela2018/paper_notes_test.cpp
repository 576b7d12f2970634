#include "analysis/koskela2018/paper_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;

TEST(PaperNotes, NameTheTablesAndFiguresOfThePaper) {
  const PaperNotes notes = paper_notes(select_for_analysis(complete_study(1)));
  EXPECT_THAT(notes.times_by_scene, HasSubstr("Table 2"));
  EXPECT_THAT(notes.times_by_method, HasSubstr("Fig. 5"));
  EXPECT_THAT(notes.ratings, HasSubstr("Fig. 6"));
  EXPECT_THAT(notes.latency, HasSubstr("Fig. 7"));
}

TEST(PaperNotes, AreEmptyForAnyOtherStudy) {
  study::StudyRecords records = complete_study(1);
  records.measures[artifacts_index].question.id = "comfort";
  const PaperNotes notes = paper_notes(select_for_analysis(records));
  EXPECT_EQ(notes.times_by_scene + notes.percentages + notes.times_by_method + notes.ratings +
                notes.means_of_ratings + notes.latency,
            "");
}

}  // namespace
}  // namespace foveola::analysis
