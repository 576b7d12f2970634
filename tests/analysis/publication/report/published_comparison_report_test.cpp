#include "analysis/publication/report/published_comparison_report.h"

#include <utility>

#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/koskela2018/paper.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

struct Compared {
  StudyTables tables;
  std::vector<ComparedNumber> numbers;
};

/// A simulated study of a published scene and the counterpart of another.
Compared simulated_comparison() {
  study::StudyRecords records = complete_study(3);
  records.scenes = {"bmw", "schoolroom"};
  records = of_kind(std::move(records), "simulated");
  Compared compared{tabulate_study(records), {}};
  compared.numbers = compare_with_published(records, compared.tables, paper());
  return compared;
}

TEST(PublishedComparisonReport, FilesSayThatDataAreSimulated) {
  const auto [tables, numbers] = simulated_comparison();
  const std::vector<CsvRow> rows =
      parse_csv(csv_of(published_comparison_table(tables, numbers)), "comparison");
  EXPECT_THAT(rows, Each(SizeIs(23)));
  EXPECT_EQ(rows.front().back(), "participant_kind");
  EXPECT_EQ(rows.size(), numbers.size() + 1);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].back(), "simulated");
  }
  const std::string html = comparison_html(tables, numbers);
  EXPECT_THAT(html, HasSubstr("<p class=\"notice\" role=\"note\">Simulated data"));
  EXPECT_THAT(html, HasSubstr("<caption><span class=\"tag\">Simulated data</span>"));
}

TEST(PublishedComparisonReport, PublishedNumbersStandAsPrintedWithTheirIntervals) {
  const auto [tables, numbers] = simulated_comparison();
  const std::string html = comparison_html(tables, numbers);
  EXPECT_THAT(html, HasSubstr("<td>6.1 [2.1, 10.1] s</td>")) << "6.1 -+ 2.13145 * 7.6 / 4";
  EXPECT_THAT(html, HasSubstr("<td>0.196</td>"));
  EXPECT_THAT(html, HasSubstr("<td>22 years</td>"));
  EXPECT_THAT(html, HasSubstr("<td>10 %</td>"));
  EXPECT_THAT(html, HasSubstr("<td>3 times</td>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">classroom</th><td>schoolroom</td>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">sponza</th><td>–</td>"));
  EXPECT_THAT(html, HasSubstr("of 20 published means, 8 of which this study has"));
  EXPECT_THAT(html, HasSubstr("Section 5.3 says in words only"));
  EXPECT_THAT(html, Not(HasSubstr("not at hand")));
}

TEST(PublishedComparisonReport, TheTerminalHasTheMeansOverScenesAndTheCounts) {
  const auto [tables, numbers] = simulated_comparison();
  const std::string text = comparison_summary(tables, numbers);
  EXPECT_THAT(text, HasSubstr("published 30.3 % (geometric mean over scenes of Table 2)\n"));
  EXPECT_THAT(text, HasSubstr("published 66.4 s (geometric mean"));
  EXPECT_THAT(text, HasSubstr("Table 2, VP and FV, ratio of means: of 20 published means"));
}

}  // namespace
}  // namespace foveola::analysis
