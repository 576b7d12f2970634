#include "analysis/koskela2018/paper_notes.h"

#include "tests/analysis/koskela2018/paper.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(PaperNotes, NameTheTablesFiguresAndSectionsOfThePaper) {
  const PaperNotes notes = paper_notes(tabulate_study(complete_study(1)), paper());
  EXPECT_THAT(notes.times_by_scene, AllOf(HasSubstr("Table 2"), HasSubstr("section 5.2")));
  EXPECT_THAT(notes.times_by_method,
              AllOf(HasSubstr("Fig. 5"), HasSubstr("around 10 % of OD’s time"),
                    HasSubstr("VP 3 times faster than OD, and FV 3 times faster than VP")));
  EXPECT_THAT(notes.ratings, AllOf(HasSubstr("Fig. 6"), HasSubstr("section 4.2")));
  EXPECT_THAT(notes.latency, AllOf(HasSubstr("Fig. 7"), HasSubstr("38 ms"), HasSubstr("5.6")));
  EXPECT_THAT(notes.background, AllOf(HasSubstr("Section 5.1"), HasSubstr("P = 0.196")));
}

TEST(PaperNotes, AreEmptyWhereNothingPublishedStandsBeside) {
  const PaperNotes notes = paper_notes(tabulate_study(complete_study(1)), std::nullopt);
  EXPECT_EQ(notes.times_by_scene + notes.percentages + notes.times_by_method + notes.ratings +
                notes.means_of_ratings + notes.latency + notes.background,
            "");
}

/// A study whose ratings are the same in all trials of a method.
StudyTables rated(double od, double vp, double fv) {
  study::StudyRecords records = complete_study(2);
  const double ratings[] = {od, vp, fv};
  for (const char* participant : {"P1", "P2"}) {
    for (const std::string& scene : records.scenes) {
      for (std::size_t method = 0; method < 3; ++method) {
        value_of(records, participant, scene, records.methods[method], "artifacts") =
            measured(ratings[method]);
      }
    }
  }
  return tabulate_study(records);
}

TEST(PaperNotes, TheOrderOfArtifactsStandsBesideFigure6) {
  EXPECT_THAT(artifacts_in_order(rated(1, 4, 2)),
              HasSubstr("are OD 1.00, FV 2.00, VP 4.00: VP has the most, and FV is nearer to OD "
                        "than to VP."));
  EXPECT_THAT(artifacts_in_order(rated(1, 2, 4)),
              HasSubstr("are OD 1.00, VP 2.00, FV 4.00: VP does not have the most, and FV is not "
                        "nearer to OD than to VP."));
  study::StudyRecords records = complete_study(2);
  records.methods[1] = "hybrid";
  EXPECT_EQ(artifacts_in_order(tabulate_study(records)), "");
}

}  // namespace
}  // namespace foveola::analysis
