#include "analysis/publication/published_comparison_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/koskela2018/background.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/csv.h"
#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

TEST(PublishedComparisonReport, FilesSayThatDataAreSimulated) {
  study::StudyRecords records = complete_study(3);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const StudyTables tables = tabulate_study(records);
  PublishedTables paper;
  paper.background = {{"offline_rendering", 2.5, 1.0}, {"age", std::nullopt, std::nullopt}};
  paper.times = {{"aula", "", "outline", "od", 12.0, 3.0},
                 {"unseen", "barn", "outline", "fv", 10.0, std::nullopt}};
  const std::vector<ComparedCell> cells = compare_with_published(
      tables, background_answers(records), paper, {{"vp", {31, 33}}, {"fv", {9, 12}}});
  const std::vector<CsvRow> rows =
      parse_csv(csv_of(published_comparison_table(tables, cells)), "comparison");
  EXPECT_THAT(rows, Each(SizeIs(14)));
  EXPECT_EQ(rows.front().back(), "participant_kind");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].back(), "simulated");
  }
  const std::string html = comparison_html(tables, cells);
  EXPECT_THAT(html, HasSubstr("<td>not at hand</td>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"notice\" role=\"note\">Simulated data"));
  EXPECT_THAT(html, HasSubstr("<caption><span class=\"tag\">Simulated data</span>"));
}

TEST(PublishedComparisonReport, AMissingStudyIsAnErrorThatNamesIt) {
  EXPECT_THAT([] { (void)report_published_comparison("none.sqlite", "results"); },
              testing::ThrowsMessage<Error>(HasSubstr("none.sqlite")));
}

}  // namespace
}  // namespace foveola::analysis
