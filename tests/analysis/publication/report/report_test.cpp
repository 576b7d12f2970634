#include "analysis/publication/report/report.h"

#include <fmt/format.h>

#include "analysis/publication/report/methods_paragraph.h"
#include "analysis/publication/tables/result_tables.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::string report_of(const study::StudyRecords& records,
                      const study::DataQualityRecords& quality = {}) {
  StudyTables tables = tabulate_study(records);
  const Background background =
      analyse_background(background_answers(records), records.protocol.analysis, tables.set);
  const Comparisons comparisons = compare_methods(tables.set, records.protocol.analysis);
  const std::optional<PublishedStudy> published = published_study_for(tables.set);
  const DataQualityReport checks = check_data_quality(tables, quality, records);
  return report_html({tables, background,
                      result_tables(records, tables, background, comparisons, checks), comparisons,
                      quality, checks, draw_figures(tables), published,
                      methods_paragraph(tables, comparisons, records, quality), std::nullopt});
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// Three people, each of whom saw every method in another place.
study::StudyRecords balanced_study() {
  study::StudyRecords records = complete_study(3);
  int trial = 0;
  for (study::TrialRow& row : records.trials) {
    row.method_position = static_cast<std::uint16_t>((trial % 3 + trial / 6) % 3);
    ++trial;
  }
  return records;
}

TEST(Report, IsOnePageWithItsFiguresInside) {
  const std::string html = report_of(golden_study_records());
  EXPECT_EQ(count_of(html, "<svg role=\"img\""), 6U);
  EXPECT_EQ(count_of(html, "</svg>"), 6U);
  EXPECT_THAT(html, Not(HasSubstr("<?xml")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
}

TEST(Report, CaptionsSayWhatWasLeftOutOfTheFigures) {
  study::StudyRecords records = golden_study_records();
  EXPECT_THAT(report_of(records),
              HasSubstr("Hollow points leave out pairs in which a time was right-censored"));
  EXPECT_THAT(report_of(records), HasSubstr("Crosses are right-censored trials."));
  change_values(records, "material", [](study::Value& value) { value = {}; });
  EXPECT_THAT(report_of(records),
              HasSubstr("Not drawn, as no participant has both times in a scene: "
                        "material."));
  EXPECT_THAT(report_of(complete_study(static_cast<int>(max_dots) + 1)),
              HasSubstr("With more than 500 participants, the points of single participants are "
                        "left out. Filled points are"));
}

TEST(Report, HasTheNumbersOfR) {
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {{"material", "fv", "od"}};
  const std::string html = report_of(records);
  EXPECT_THAT(html, HasSubstr("10.1 [9.2, 11.0]"));
  const auto golden = golden_study();
  EXPECT_THAT(html, HasSubstr(fmt::format(
                        "<td>{:.2f} [{:.2f}, {:.2f}]</td>", golden.at("material.fv.log_r"),
                        golden.at("material.fv.log_r_low"), golden.at("material.fv.log_r_high"))));
}

TEST(Report, SaysWhichSessionsWereAmendedAndHow) {
  study::StudyRecords records = golden_study_records();
  EXPECT_THAT(report_of(records), HasSubstr("None: every session followed the protocol"));
  records.amended.push_back({"P02", {"0a1b2c", {"timing.timeout_s"}, "title = 'x'"}});
  const std::string html = report_of(records);
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">P02</th><td>timing.timeout_s</td><td>0a1b2c</td>"
                              "<td>yes</td>"));
  EXPECT_THAT(html, HasSubstr("1 of the 8 analysed sessions followed a protocol that was amended"));
}

TEST(Report, PublishedValuesAreShownWithTheStudys) {
  study::StudyRecords records = golden_study_records();
  records.protocol.analysis.primary = {{"material", "fv", "od"}};
  const std::string html = report_of(records);
  EXPECT_THAT(html, HasSubstr("geometric mean over scenes of Table 2"));
  // FV until the material, 9.1 % published.
  const double own = golden_study().at("material.fv.geometric_mean_percent");
  EXPECT_THAT(html, HasSubstr(fmt::format("<td>9.1 %</td><td>{:+.1f} points</td>", own - 9.1025)));
  EXPECT_THAT(html, HasSubstr("<td>17.4 s</td>"));
  EXPECT_THAT(html, HasSubstr("<td>3.5 ± 1.3</td>")) << "Table 1, graphics_3d";
  EXPECT_THAT(html, HasSubstr("and found P = 0.196."));
  EXPECT_THAT(html, Not(HasSubstr(">published: "))) << "it shows none of the paper's scenes";
}

TEST(Report, ScenesStandAboveTheirRowOfThePublishedTable2) {
  study::StudyRecords records = complete_study(3);
  records.scenes = {"bmw", "meeting-room"};
  const std::string html = report_of(records);
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">published: bmw</th><td>6.1 ± 7.6</td>"
                              "<td>41.8 ± 9.8</td><td>20.8 ± 1.9</td><td>16</td>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">published: conference (counterpart: "
                              "meeting-room)</th><td>41.9 ± 59.7</td>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">published: bmw</th><td>33.6 ± 15.1</td>"
                              "<td>11.8 ± 5.3</td></tr>"));
}

TEST(Report, NothingPublishedStandsBesideAnotherStudy) {
  study::StudyRecords records = complete_study(3);
  records.scenes = {"bmw", "meeting-room"};
  records.measures[artifacts_index].question.id = "comfort";
  const std::string html = report_of(records);
  EXPECT_THAT(html, Not(HasSubstr("published:")));
  EXPECT_THAT(html, Not(HasSubstr("Table 2")));
  EXPECT_THAT(html, Not(HasSubstr("0.196")));
}

TEST(Report, RaisesAFlagWhereAGateWasMissed) {
  study::DataQualityRecords quality;
  EXPECT_THAT(report_of(balanced_study(), quality), Not(HasSubstr("class=\"flags\"")));
  quality.gaze_runs.push_back({"P1", 1, 4.0, 0.2, 0.1, false});
  const std::string html = report_of(balanced_study(), quality);
  EXPECT_THAT(html, HasSubstr("class=\"flags\""));
  EXPECT_THAT(html, HasSubstr("⚑ Validation of the gaze: 0 of 3 participants passed"));
  EXPECT_THAT(html, HasSubstr("<td>⚑ flagged</td>"));
}

TEST(Report, WhatWasPlannedStandsApart) {
  study::StudyRecords records = complete_study(4);
  EXPECT_THAT(report_of(records), HasSubstr("The protocol plans no comparison"));
  EXPECT_THAT(report_of(records), Not(HasSubstr("Planned comparisons.")));
  records.protocol.analysis.participants = 16;
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  const std::string html = report_of(records);
  for (const char* words :
       {"The protocol planned 1 primary comparison", "It planned 16 participants; 4 are analysed.",
        "Planned comparisons.", "Exploratory comparisons, P-values unadjusted.",
        "Appendix: sensitivity analyses", "No model was fitted by R."}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
}

TEST(Report, ShowsTheFloorOfReactionTimes) {
  EXPECT_THAT(report_of(complete_study(2)), HasSubstr("No reaction test was recorded"));
  study::DataQualityRecords quality;
  quality.reactions = {{"P1", 0.25, false}, {"P1", 0.31, false}, {"P1", -0.1, true}};
  EXPECT_THAT(report_of(complete_study(2), quality), HasSubstr("<td>0.280</td>"));
}

TEST(Report, ListsWhatWasLeftOut) {
  const std::string html = report_of(golden_study_records());
  EXPECT_THAT(
      html,
      HasSubstr("<li>2 × right-censored: the time-out is only a lower bound of the time</li>"));
  EXPECT_THAT(html, HasSubstr("<li>1 × session interrupted</li>"));
  EXPECT_THAT(report_of(complete_study(2)), HasSubstr("Nothing: every session was completed"));
}

TEST(Report, ManyExclusionsAreCutWithACount) {
  study::StudyRecords records = complete_study(2);
  for (int i = 0; i < 150; ++i) {
    records.sessions.push_back({fmt::format("X{}", i), "human", "withdrawn", {}, {}});
  }
  const std::string html = report_of(records);
  EXPECT_THAT(html, HasSubstr("150 × session withdrawn"));
  EXPECT_THAT(html, HasSubstr("And 50 more"));
}

TEST(Report, HostileStringsStayText) {
  const std::string hostile = "</td><script>alert('x')</script>&\"";
  study::StudyRecords records = complete_study(3);
  records.protocol.name = hostile;
  records.protocol.title = hostile;
  records.protocol.sha256 = hostile;
  records.scenes[0] = hostile + " scene";
  records.methods[2] = hostile + " method";
  records.sessions.push_back({hostile, "human", hostile, {}, {}});
  for (study::Measure& measure : records.measures) {
    measure.question.text = hostile;
  }
  records.measures[artifacts_index].question.labels = {hostile, hostile};
  for (std::string& word : records.words) {
    word = word == "graphics_3d" ? hostile : word;
  }
  const std::string html = report_of(records);
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot; scene"));
}

// The markup that readers who see, hear or print the report rely on.

std::string simulated_report() {
  study::DataQualityRecords quality;
  quality.gaze_runs.push_back({"P01", 1, 4.0, 0.2, 0.1, false});
  return report_of(of_kind(golden_study_records(), "simulated"), quality);
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
