#include "analysis/publication/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
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
              ElementsAre("relative_times", "times_in_seconds", "time_to_outline",
                          "time_to_material", "ratings_artifacts"));
  for (const Figure& figure : figures) {
    EXPECT_THAT(figure.svg, HasSubstr("</svg>"));
    EXPECT_THAT(figure.svg, HasSubstr("<text>FV</text>"));
    EXPECT_TRUE(pdf_of(figure).starts_with("%PDF-"));
    EXPECT_THAT(pdf_of(figure), Not(HasSubstr("CreationDate")));
    EXPECT_TRUE(png_of(figure).starts_with("\x89PNG"));
  }
  // From R: the means and deviations of the ratings.
  EXPECT_THAT(figures.back().svg, HasSubstr("2.42 ± 0.78"));
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
  EXPECT_EQ(draw_figures(tabulate_study(complete_study(1))).size(), 5U);
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
  EXPECT_THAT(
      names_of(draw_figures(tabulate_study(records))),
      ElementsAre("times_in_seconds", "time_to_outline", "time_to_material", "ratings_artifacts"));
}

/// complete_study() with ratings on a scale of many points: 10, 20, 31 by the first participant
/// with od, vp and fv, and 7 more by each next one.
study::StudyRecords study_on_a_wide_scale(int participants) {
  study::StudyRecords records = complete_study(participants);
  study::Question& rating = records.measures[artifacts_index].question;
  rating.minimum = 0.0;
  rating.maximum = 100.0;
  rating.labels = {"not at <all>", "very"};
  const std::vector<double> of_methods = {10.0, 20.0, 31.0};
  for (const study::TrialRow& row : records.trials) {
    value_of(records, records.sessions[row.session].participant, records.scenes[row.scene],
             records.methods[row.method], "artifacts") =
        measured(of_methods.at(row.method) + 7.0 * (row.session % 8));
  }
  return records;
}

TEST(Figures, OnAScaleOfManyPointsEveryParticipantIsDrawnBetweenTheNamedEnds) {
  const std::vector<Figure> figures = draw_figures(tabulate_study(study_on_a_wide_scale(3)));
  ASSERT_THAT(names_of(figures),
              ElementsAre("relative_times", "times_in_seconds", "time_to_outline",
                          "time_to_material", "ratings_artifacts"));
  const Figure& figure = figures.back();
  EXPECT_THAT(figure.script,
              HasSubstr("10 0\n20 1\n31 2\n\n17 0\n27 1\n38 2\n\n24 0\n34 1\n45 2\n\nEND"));
  // By hand: 17 -+ t(0.975, 2) 7 / sqrt(3), with t = 4.30265.
  EXPECT_THAT(figure.script, ContainsRegex("\n17 -0\\.388[0-9]* 34\\.388[0-9]* -0\\.24\n"));
  EXPECT_THAT(figure.script, HasSubstr("set xrange [0:100]"));
  EXPECT_THAT(figure.svg,
              AllOf(HasSubstr("<text>not at &lt;all></text>"), HasSubstr("<text>very</text>"),
                    HasSubstr("<text>Ratings, artifacts, points</text>")));
  EXPECT_TRUE(pdf_of(figure).starts_with("%PDF-"));
  EXPECT_TRUE(png_of(figure).starts_with("\x89PNG"));
}

TEST(Figures, ManyParticipantsOnAWideScaleAreDrawnWithoutDots) {
  const auto script_of = [](int participants) {
    return draw_figures(tabulate_study(study_on_a_wide_scale(participants))).back().script;
  };
  EXPECT_THAT(script_of(2), HasSubstr("with lines"));
  EXPECT_THAT(script_of(static_cast<int>(most_dots) + 1), Not(HasSubstr("with lines")));
  EXPECT_THAT(script_of(1), HasSubstr("10 10 10 -0.24")) << "a mean without an interval";
}

TEST(Figures, NumbersOfAWideRangeAreDrawnAsFarAsTheyReach) {
  study::StudyRecords records = study_on_a_wide_scale(1);
  study::Question& rating = records.measures[artifacts_index].question;
  rating.kind = study::QuestionKind::number;
  rating.maximum = 1e6;
  rating.labels.clear();
  EXPECT_THAT(draw_figures(tabulate_study(records)).back().script,
              AllOf(HasSubstr("set xrange [8.95:32.05]"), HasSubstr("'Ratings, artifacts'")));
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
