#include "analysis/publication/latex_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<TextFile> latex_of(const study::StudyRecords& records) {
  const StudyTables tables = tabulate_study(records);
  return latex_tables(tables, compare_methods(tables.set, {}));
}

TEST(LatexTables, HaveTheNumbersOfR) {
  const std::vector<TextFile> files = latex_of(golden_study_records());
  ASSERT_EQ(files.size(), 4U);
  EXPECT_THAT(files[1].content, HasSubstr("FV & outline & 8 & "));
  EXPECT_THAT(files[1].content, HasSubstr("10.1 [9.2, 11.0] \\\\"));
  EXPECT_THAT(files[2].content, HasSubstr("1.74 $\\pm$ 0.62"));
}

TEST(LatexTables, EveryCaptionSaysThatDataAreSimulated) {
  study::StudyRecords records = complete_study(3);
  for (const TextFile& file : latex_of(records)) {
    EXPECT_THAT(file.content, Not(HasSubstr("Simulated")));
  }
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  for (const TextFile& file : latex_of(records)) {
    EXPECT_THAT(file.content, HasSubstr("\\caption{\\textbf{Simulated data.} ")) << file.name;
  }
}

TEST(LatexTables, NamesCannotBecomeCommands) {
  EXPECT_EQ(escape_latex("a_b & 50 % of #1 {x} $y$ ~^\\input"),
            "a\\_b \\& 50 \\% of \\#1 \\{x\\} \\$y\\$ \\~{}\\^{}\\textbackslash{}input");
  EXPECT_EQ(escape_latex("1 ± 2, –"), "1 $\\pm$ 2, --");
  study::StudyRecords records = complete_study(2);
  records.scenes[0] = "aula\\input{x}";
  for (study::TrialRow& row : records.trials) {
    row.scene = row.scene == "aula" ? records.scenes[0] : row.scene;
  }
  EXPECT_THAT(latex_of(records)[0].content, Not(HasSubstr("\\input")));
}

TEST(LatexTables, SmallPValuesAreWrittenAsPowersOfTen) {
  const StudyTables tables = tabulate_study(golden_study_records());
  Comparisons comparisons = compare_methods(tables.set, {});
  comparisons.methods.at(0).ratio->logs.p = 3.31e-5;
  comparisons.methods.at(0).ranks->p = 0.0;
  EXPECT_THAT(latex_tables(tables, comparisons).back().content,
              testing::AllOf(HasSubstr(" & $3.3 \\times 10^{-5}$ & "),
                             HasSubstr(" & $< 10^{-300}$ \\\\\n")));
}

TEST(LatexTables, OneMethodHasNoComparisons) {
  study::StudyRecords records = complete_study(2);
  records.methods = {"od"};
  EXPECT_EQ(latex_of(records).size(), 3U);
}

}  // namespace
}  // namespace foveola::analysis
