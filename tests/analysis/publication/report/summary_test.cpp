#include "analysis/publication/report/summary.h"

#include "analysis/publication/tables/result_tables.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::string summary_of(const study::StudyRecords& records) {
  StudyTables tables = tabulate_study(records);
  const Background background =
      analyse_background(background_answers(records), records.protocol.analysis, tables.set);
  const Comparisons comparisons = compare_methods(tables.set, records.protocol.analysis);
  return terminal_summary(tables,
                          result_tables(records, tables, background, comparisons,
                                        check_data_quality(tables, {}, records)),
                          comparisons, background, published_study_for(tables.set));
}

TEST(Summary, HasTheMainNumbers) {
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {{"material", "fv", "od"}};
  const std::string text = summary_of(records);
  // From R, in data/golden/study_values.csv.
  EXPECT_THAT(text, HasSubstr("10.1 [9.2, 11.0]"));
  EXPECT_THAT(text, HasSubstr("log(OD/FV), material"));
  EXPECT_THAT(text, HasSubstr("1.74 ± 0.62"));
  EXPECT_THAT(text, HasSubstr("8 participants, 3 scenes, 3 methods"));
  EXPECT_THAT(text, Not(HasSubstr("imulated")));
}

TEST(Summary, BeginsWithThePrimaryResults) {
  EXPECT_THAT(summary_of(complete_study(4)),
              HasSubstr("4 participants, 2 scenes, 3 methods\n  VP took "));
}

TEST(Summary, HasThePublishedNumbersBesideTheStudys) {
  study::StudyRecords records = golden_study_records();
  records.scenes[0] = "bmw";
  const std::string text = summary_of(records);
  EXPECT_THAT(text, HasSubstr("geometric mean over scenes of Table 2"));
  EXPECT_THAT(text, HasSubstr("published: bmw"));
  EXPECT_THAT(text, HasSubstr("30.3 %"));
  EXPECT_THAT(text, HasSubstr("3.5 ± 1.3"));
  records.measures[artifacts_index].question.id = "comfort";
  EXPECT_THAT(summary_of(records), Not(HasSubstr("published")));
}

TEST(Summary, NamesCannotSteerTheTerminal) {
  study::StudyRecords records = complete_study(2);
  records.scenes[0] = "au\x1b[31mla";
  const std::string text = summary_of(records);
  EXPECT_THAT(text, HasSubstr("au?[31mla"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace foveola::analysis
