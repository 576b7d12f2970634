#include "analysis/publication/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> names_of(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) {
    names.push_back(figure.name);
  }
  return names;
}

TEST(Figures, ThePublishedOnesAreDrawn) {
  const std::vector<Figure> figures = draw_figures(tabulate_study(golden_study_records()));
  EXPECT_THAT(names_of(figures),
              ElementsAre("relative_times", "times_in_seconds", "ratings_artifacts"));
  for (const Figure& figure : figures) {
    EXPECT_THAT(figure.svg, HasSubstr("</svg>"));
    EXPECT_THAT(figure.svg, HasSubstr("<text>FV</text>"));
    EXPECT_TRUE(pdf_of(figure).starts_with("%PDF-"));
    EXPECT_THAT(pdf_of(figure), Not(HasSubstr("CreationDate")));
    EXPECT_TRUE(png_of(figure).starts_with("\x89PNG"));
  }
  // From R: the means and deviations of the ratings.
  EXPECT_THAT(figures[2].svg, HasSubstr("2.42 ± 0.78"));
}

TEST(Figures, EveryFileSaysWhoseDataItShows) {
  study::StudyRecords records = complete_study(3);
  for (const Figure& figure : draw_figures(tabulate_study(records))) {
    EXPECT_THAT(figure.svg, Not(HasSubstr(" data</text>")));
  }
  for (const char* kind : {"simulated", "pilot"}) {
    for (study::SessionRow& session : records.sessions) {
      session.kind = kind;
    }
    const std::string mark = std::string(kind) == "pilot" ? "Pilot data" : "Simulated data";
    for (const Figure& figure : draw_figures(tabulate_study(records))) {
      EXPECT_THAT(figure.svg, HasSubstr("<text>" + mark + "</text>")) << figure.name;
    }
  }
}

TEST(Figures, ManyParticipantsAreDrawnWithoutDots) {
  const auto length_of = [](int participants) {
    const std::vector<Figure> figures = draw_figures(tabulate_study(complete_study(participants)));
    return figures.at(0).svg.size();
  };
  EXPECT_LT(length_of(static_cast<int>(most_dots) + 1), length_of(50));
}

TEST(Figures, OneParticipantIsDrawnWithoutIntervals) {
  EXPECT_EQ(draw_figures(tabulate_study(complete_study(1))).size(), 3U);
}

TEST(Figures, WithoutValuesThereIsNoFigure) {
  study::StudyRecords records = complete_study(2);
  records.values.assign(records.values.size(), {});
  EXPECT_THAT(draw_figures(tabulate_study(records)), IsEmpty());
}

TEST(Figures, OneMethodHasNoRelativeFigure) {
  study::StudyRecords records = complete_study(2);
  records.methods = {"od"};
  keep_trials(records, [](const study::TrialRow& row) { return row.method == 0; });
  EXPECT_THAT(names_of(draw_figures(tabulate_study(records))),
              ElementsAre("times_in_seconds", "ratings_artifacts"));
}

TEST(Figures, HostileNamesStayText) {
  study::StudyRecords records = complete_study(2);
  const std::string hostile = "</text><script>'`id`\n\"@x";
  records.methods[2] = hostile;
  for (const Figure& figure : draw_figures(tabulate_study(records))) {
    EXPECT_THAT(figure.svg, HasSubstr("&lt;/text>&lt;script>'`id` \"@x"));
    EXPECT_THAT(figure.svg, Not(HasSubstr("<script")));
  }
}

}  // namespace
}  // namespace foveola::analysis
