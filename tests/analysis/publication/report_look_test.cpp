// The markup that readers who see, hear or print the report rely on.
#include <string>
#include <vector>

#include "analysis/publication/methods_paragraph.h"
#include "analysis/publication/report.h"
#include "analysis/publication/trial_data.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::string simulated_report() {
  const study::StudyRecords records = of_kind(golden_study_records(), "simulated");
  study::DataQualityRecords quality;
  quality.gaze_runs.push_back({"P01", 1, 4.0, 0.2, 0.1, false});
  StudyTables tables = tabulate_study(records);
  const Background background =
      analyse_background(background_answers(records), records.protocol.analysis, tables.set);
  const Comparisons comparisons = compare_methods(tables.set, records.protocol.analysis);
  return report_html({tables, background, answers_by_question(records, tables.set),
                      questionnaire_scores(records, tables.set), comparisons, quality,
                      check_data_quality(tables, quality, records), draw_figures(tables),
                      std::optional<PublishedStudy>{},
                      methods_paragraph(tables, comparisons, records, quality), std::nullopt});
}

/// The texts from each `begin` to the next `end`.
std::vector<std::string> parts(const std::string& html, const std::string& begin,
                               const std::string& end) {
  std::vector<std::string> found;
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at + 1)) {
    found.push_back(html.substr(at, html.find(end, at) - at));
  }
  return found;
}

TEST(ReportLook, ThePageNamesItsLanguageAndFitsNarrowScreens) {
  const std::string html = simulated_report();
  EXPECT_THAT(html, HasSubstr("<html lang=\"en\">"));
  EXPECT_THAT(html, HasSubstr("content=\"width=device-width, initial-scale=1\""));
  EXPECT_EQ(parts(html, "<main>", "</main>").size(), 1U);
}

TEST(ReportLook, OneHeadingOfThePageAndOneOfEachSection) {
  const std::string html = simulated_report();
  EXPECT_EQ(parts(html, "<h1>", "</h1>").size(), 1U);
  EXPECT_GE(parts(html, "<section>", "</section>").size(), 8U);
  EXPECT_THAT(parts(html, "<section>\n", "</h2>"), Each(StartsWith("<section>\n<h2>")));
  EXPECT_THAT(html, Not(HasSubstr("<h3")));
}

TEST(ReportLook, EveryTableHasACaptionAndHeadingsForRowsAndColumns) {
  const std::vector<std::string> tables = parts(simulated_report(), "<table", "</table>");
  EXPECT_GE(tables.size(), 10U);
  EXPECT_THAT(tables, Each(HasSubstr("<caption><span class=\"tag\">Simulated data</span>")));
  EXPECT_THAT(tables, Each(HasSubstr("<th scope=\"col\">")));
  EXPECT_THAT(tables, Each(HasSubstr("<tr><th scope=\"row\">")));
}

TEST(ReportLook, EveryFigureHasANameACaptionAndAMark) {
  const std::vector<std::string> figures = parts(simulated_report(), "<figure>", "</figure>");
  EXPECT_EQ(figures.size(), 6U);
  EXPECT_THAT(figures, Each(ContainsRegex("<svg role=\"img\" aria-label=\"[A-Z]")));
  EXPECT_THAT(figures, Each(HasSubstr("<figcaption><span class=\"tag\">Simulated data</span>")));
  EXPECT_THAT(figures, Each(HasSubstr("<text>Simulated data</text>")));
}

/// Parts that are wider than the screen can be scrolled by keys.
TEST(ReportLook, WhateverScrollsIsReachedByKeys) {
  const std::string html = simulated_report();
  const std::vector<std::string> boxes = parts(html, "<div class=\"scroll\"", ">");
  EXPECT_EQ(boxes.size(), parts(html, "<table", ">").size() + parts(html, "<figure", ">").size());
  EXPECT_THAT(boxes, Each(HasSubstr("role=\"group\" aria-label=\"")));
  EXPECT_THAT(boxes, Each(HasSubstr("tabindex=\"0\"")));
}

TEST(ReportLook, FlagsAreWordsAndASignAndNotOnlyAColor) {
  const std::string html = simulated_report();
  const std::vector<std::string> flags = parts(html, "<div class=\"flags\"", "</div>");
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_THAT(flags[0], HasSubstr("Data-quality limits missed:"));
  EXPECT_THAT(flags[0], HasSubstr("<li>⚑ Validation of the gaze"));
  EXPECT_THAT(html, HasSubstr("<td>⚑ flagged</td>"));
}

TEST(ReportLook, MethodsDifferByShapeAsWellAsColor) {
  const std::vector<Figure> figures = draw_figures(tabulate_study(complete_study(4)));
  ASSERT_FALSE(figures.empty());
  // gnuplot's names: point type 5, a square, is gpPt4, and 9, a triangle, gpPt8.
  for (const char* point : {"#gpPt4'", "#gpPt8'"}) {
    EXPECT_THAT(figures[0].svg, HasSubstr(point));
  }
}

}  // namespace
}  // namespace foveola::analysis
