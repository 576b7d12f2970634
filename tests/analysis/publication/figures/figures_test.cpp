#include "analysis/publication/figures/figures.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "analysis/publication/figures/rating_figures.h"
#include "analysis/publication/figures/scene_figure.h"
#include "analysis/publication/figures/time_figures.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

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
              ElementsAre("relative_times", "relative_times_by_scene", "times_in_seconds",
                          "time_to_outline", "time_to_material", "ratings_artifacts"));
  for (const Figure& figure : figures) {
    EXPECT_THAT(figure.svg, HasSubstr("</svg>"));
    EXPECT_THAT(figure.svg, HasSubstr("<text>FV</text>"));
    EXPECT_TRUE(figure.pdf.starts_with("%PDF-"));
    EXPECT_THAT(figure.pdf, Not(HasSubstr("CreationDate")));
    EXPECT_TRUE(figure.png.starts_with("\x89PNG"));
  }
  // From R: the means and deviations of the ratings.
  EXPECT_THAT(figures.back().svg, HasSubstr("2.42 ± 0.78"));
}

/// The lines of a data block of the figure's script.
std::string block_of(const Figure& figure, const std::string& name) {
  const std::string begin = name + " << END\n";
  const std::size_t at = figure.script.find(begin);
  return at == std::string::npos
             ? "no such block"
             : figure.script.substr(
                   at + begin.size(),
                   figure.script.find("END\n", at + begin.size()) - at - begin.size());
}

TEST(Figures, RelativeTimesJoinEachParticipantsPointsOnALogarithmicAxis) {
  const Figure figure = relative_figure(tabulate_study(complete_study(2))).value();
  // By hand, as a participant's ratios are the same in both scenes: vp takes 1.1 / 3.1 of od's time
  // for P1 and 1.2 / 3.2 for P2, fv 1.1 / 5.1 and 1.2 / 5.2. The points lie in the middle of rows
  // 64 units high, below a heading of 26.
  const std::string outline =
      "35\\.48387[0-9]* 0\\.98625\n21\\.56862[0-9]* 1\\.98625\n\n"
      "37\\.5[0-9]* 0\\.98625\n23\\.07692[0-9]* 1\\.98625\n\n";
  EXPECT_THAT(block_of(figure, "$joined"), ContainsRegex("^" + outline));
  EXPECT_THAT(block_of(figure, "$participants_1"),
              ContainsRegex("^35\\.48387[0-9]* 0\\.98625\n37\\.5[0-9]* 0\\.98625\n"));
  EXPECT_THAT(figure.script, AllOf(HasSubstr("set logscale x\n"), HasSubstr("set logscale x2\n"),
                                   HasSubstr("$joined using 1:2 with lines")));
}

TEST(Figures, ASingleOtherMethodHasPointsAndNothingToJoin) {
  study::StudyRecords records = complete_study(3);
  records.methods = {"od", "vp"};
  keep_trials(records, [](const study::TrialRow& row) { return row.method < 2; });
  const StudyTables tables = tabulate_study(records);
  EXPECT_THAT(relative_figure(tables).value().script,
              AllOf(HasSubstr("$participants_1 using"), Not(HasSubstr("$joined using"))));
  EXPECT_THAT(seconds_figure(tables).value().script, HasSubstr("$joined using"));
}

TEST(Figures, SecondsJoinEveryMethodsPoints) {
  const Figure figure = seconds_figure(tabulate_study(complete_study(1))).value();
  // By hand: sqrt(10.5 x 14.5) s over 1.1, 3.1 and 5.1.
  EXPECT_THAT(block_of(figure, "$joined"),
              ContainsRegex("^11\\.2172[0-9]* [0-9.]*\n3\\.9803[0-9]* [0-9.]*\n"
                            "2\\.4194[0-9]* [0-9.]*\n\n"));
  EXPECT_THAT(figure.script, HasSubstr("set logscale x\n"));
}

/// "VALUE LOW HIGH " of one row of times_by_scene or times_by_method, as the table writes them.
std::string ratio_of(const CsvRow& heading, const CsvRow& row) {
  std::string ratio;
  for (const char* column : {"geometric_mean_percent_of_baseline", "ci95_low_percent_of_baseline",
                             "ci95_high_percent_of_baseline"}) {
    const auto at = std::find(heading.begin(), heading.end(), column) - heading.begin();
    ratio += row.at(static_cast<std::size_t>(at)) + " ";
  }
  return ratio;
}

TEST(Figures, IntervalsOfEachSceneAreThoseOfTheTables) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const Figure figure = relative_scene_figure(tables).value();
  EXPECT_THAT(figure.script, HasSubstr("set logscale x\n"));
  std::size_t drawn = 0;
  for (const Table& table : {times_by_scene(tables), times_by_method(tables)}) {
    const std::vector<CsvRow> rows = parse_csv(csv_of(table), table.id);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const std::string ratio = ratio_of(rows[0], rows[i]);
      if (ratio != "   ") {
        EXPECT_THAT(figure.script, HasSubstr("\n" + ratio)) << i;
        ++drawn;
      }
    }
  }
  EXPECT_EQ(drawn, 2U * 2U * (3U + 1U));  // Marks, methods, scenes and all of them.
}

/// In the golden study od's time ran out for P03 in aula, and vp's time of P02 is missing there.
TEST(Figures, ScenesInWhichATimeRanOutAreHollow) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const Figure figure = relative_scene_figure(tables).value();
  const auto lines_of = [&](const std::string& block) {
    const std::string text = block_of(figure, block);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines_of("$ratios_1"), 4);         // Two marks in barn and cave.
  EXPECT_EQ(lines_of("$hollow_ratios_1"), 4);  // Two marks in aula and in all scenes.
  EXPECT_THAT(figure.script, HasSubstr("set label '6' at graph 1.02"));
  const Figure complete = relative_scene_figure(tabulate_study(complete_study(3))).value();
  EXPECT_EQ(block_of(complete, "$hollow_ratios_1"), "");
}

TEST(Figures, MarksWithoutAnyTimeAreLeftOut) {
  study::StudyRecords records = complete_study(3);
  change_values(records, "material", [](study::Value& value) { value = right_censored(60.0); });
  for (const Figure& figure : draw_figures(tabulate_study(records))) {
    if (figure.name == "time_to_material") {
      EXPECT_THAT(block_of(figure, "$censored0"), HasSubstr("60 1\n"));
    } else {
      EXPECT_THAT(figure.svg, Not(HasSubstr("material"))) << figure.name;
    }
  }
}

TEST(Figures, WithoutValuesThereIsNoFigure) {
  study::StudyRecords records = complete_study(2);
  records.values.assign(records.values.size(), {});
  EXPECT_THAT(draw_figures(tabulate_study(records)), IsEmpty());
}

TEST(Figures, OneMethodHasNoRelativeFigure) {
  EXPECT_THAT(
      names_of(draw_figures(tabulate_study(with_od_alone(complete_study(2))))),
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
  const Figure& figure = figures.back();
  ASSERT_EQ(figure.name, "ratings_artifacts");
  EXPECT_THAT(figure.script,
              HasSubstr("10 0\n20 1\n31 2\n\n17 0\n27 1\n38 2\n\n24 0\n34 1\n45 2\n\nEND"));
  // By hand: 17 -+ t(0.975, 2) 7 / sqrt(3), with t = 4.30265.
  EXPECT_THAT(figure.script, ContainsRegex("\n17 -0\\.388[0-9]* 34\\.388[0-9]* -0\\.34\n"));
  EXPECT_THAT(figure.script, HasSubstr("set xrange [0:100]"));
  EXPECT_THAT(figure.svg,
              AllOf(HasSubstr("<text>not at &lt;all></text>"), HasSubstr("<text>very</text>"),
                    HasSubstr("<text>Ratings, artifacts, points</text>")));
}

TEST(Figures, BarsHaveTheLabelsOfTheScalesEndsAndCounts) {
  study::StudyRecords records = complete_study(3);
  records.measures[artifacts_index].question.labels = {"κανένα", "παντού"};
  const Figure figure = rating_figure(tabulate_study(records), artifacts_index).value();
  // By hand: of two scenes of each participant with od the answers 2, 3 and 1.
  EXPECT_THAT(figure.svg,
              AllOf(HasSubstr("<text>1 κανένα</text>"), HasSubstr("<text>5 παντού</text>"),
                    HasSubstr("<text>n = 6</text>"), HasSubstr("<text>2</text>")));
  EXPECT_THAT(figure.script, HasSubstr("set label '2' at 16.666"));
}

/// A count of three digits needs more of the bar than one of a single digit.
TEST(Figures, CountsStandInBarsWhereTheirDigitsFit) {
  study::StudyRecords records = complete_study(1000);
  change_values(records, "artifacts", [](study::Value& value) { value = measured(1.0); });
  for (int i = 1; i <= 120; ++i) {  // 6 % of od's answers.
    value_of(records, fmt::format("P{}", 1 + (i - 1) / 2), i % 2 == 0 ? "aula" : "barn", "od",
             "artifacts") = measured(5.0);
  }
  const Figure figure = rating_figure(tabulate_study(records), artifacts_index).value();
  EXPECT_THAT(figure.script, AllOf(HasSubstr("set label '1880' at 47,0"), Not(HasSubstr("'120'"))));
}

TEST(Figures, ManyParticipantsOnAWideScaleAreDrawnWithoutDots) {
  const auto script_of = [](int participants) {
    return draw_figures(tabulate_study(study_on_a_wide_scale(participants))).back().script;
  };
  EXPECT_THAT(script_of(2), HasSubstr("with lines"));
  EXPECT_THAT(script_of(static_cast<int>(max_dots) + 1), Not(HasSubstr("with lines")));
  EXPECT_THAT(script_of(1), HasSubstr("10 10 10 -0.34")) << "a mean without an interval";
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
  const std::string hostile = "</text><script>'`id`\n\"@x 5 % ;";
  records.methods[2] = hostile;
  for (const Figure& figure : draw_figures(tabulate_study(records))) {
    EXPECT_THAT(figure.svg, HasSubstr("&lt;/text>&lt;script>'`id` \"@x 5 % ;"));
    EXPECT_THAT(figure.svg, Not(HasSubstr("<script")));
  }
}

}  // namespace
}  // namespace foveola::analysis
