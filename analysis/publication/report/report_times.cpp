#include <algorithm>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/figures/scene_figure.h"
#include "analysis/publication/figures/time_figures.h"
#include "analysis/publication/report/printed_results.h"
#include "analysis/publication/report/report_parts.h"
#include "analysis/publication/report/report_sections.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string plan_in_words(const Comparisons& comparisons, std::size_t participants) {
  const study::AnalysisPlan& plan = comparisons.plan;
  std::string text =
      plan.primary.empty()
          ? "The protocol plans no comparison: all comparisons are exploratory, and their P-values "
            "are not adjusted for their number."
          : fmt::format(
                "The protocol planned {} before there were data, at a level of {:g} over all "
                "of them together (Holm); everything else is exploratory, and not adjusted.",
                count_with_noun(plan.primary.size(), "primary comparison"), plan.alpha);
  if (plan.participants && static_cast<std::size_t>(*plan.participants) != participants) {
    text +=
        fmt::format(" It planned {}; {} analysed.",
                    count_with_noun(static_cast<std::size_t>(*plan.participants), "participant"),
                    participants == 1 ? "1 is" : fmt::format("{} are", participants));
  }
  return text;
}

std::string models_in_words(const FittedModels& models) {
  if (models.versions.empty()) {
    return fmt::format("No model was fitted by R{}{}.", models.missing.empty() ? "" : ": ",
                       models.missing);
  }
  std::vector<std::string> versions;
  for (const auto& [name, version] : models.versions) {
    versions.push_back(fmt::format("{} {}", name, version));
  }
  return fmt::format("Models were fitted by {}; models.R has the formulas.", comma_list(versions));
}

std::string tables_html(const StudyTables& tables, const std::vector<PrintedTable>& printed) {
  std::string html;
  for (const PrintedTable& table : printed) {
    html += table_html(tables, table);
  }
  return html;
}

std::string bars_explained(const Measure& measure) {
  return fmt::format(
      "Bars are the shares of the answers, {}, with their counts where these fit. At the right: "
      "mean ± standard deviation, and n, the number of answers.",
      study::scale_in_words(measure));
}

std::string means_explained(const StudyTables& tables, const Measure& measure) {
  const std::string participants =
      draws_participants(tables)
          ? fmt::format(
                "Hollow points are participants: each one’s mean, {}, over the scenes rated with "
                "every method, joined by thin lines from method to method.",
                study::scale_in_words(measure))
          : points_left_out();
  return fmt::format(
      "{} Filled points are the means over n participants, with 95 % confidence intervals over "
      "participants, {}, which may exceed the axis.",
      participants, in_these_scenes(tables));
}

std::string figure_explained(const StudyTables& tables, const Measure& measure) {
  return measure.points().empty() ? means_explained(tables, measure) : bars_explained(measure);
}

std::string background_in_words(const Background& background) {
  if (background.scale.empty()) {
    return "The protocol states no scale of background ([analysis] background), so there is no "
           "correlation with it.";
  }
  if (!background.correlation) {
    return "The protocol plans no comparison of times with the baseline, with which background "
           "could be correlated.";
  }
  return fmt::format(
      "Background is the mean of the answers to {}, as the protocol states. Its correlation with "
      "the speed-up in the first planned comparison of times is the only one that is tested.",
      comma_list(background.scale));
}

/// Explains the points and lines of participants in a figure of this many methods.
std::string participants_explained(const StudyTables& tables, std::size_t methods) {
  return !draws_participants(tables)
             ? points_left_out()
             : fmt::format(
                   "Hollow points are participants: each one’s geometric mean over the scenes in "
                   "which every method’s time was measured{}.",
                   methods > 1 ? ", joined by thin lines from method to method" : "");
}

std::string estimates_explained(const StudyTables& tables) {
  return fmt::format(
      "Filled points are the geometric means over participants, with 95 % confidence intervals "
      "over "
      "participants, {}.",
      in_these_scenes(tables));
}

std::string relative_axis_explained(const StudyTables& tables) {
  return fmt::format(
      "The axis is logarithmic: per cent of {}’s time below, and above how many times as fast that "
      "is, 2× at 50 %. The dark vertical line is no change.",
      baseline_label(tables));
}

/// Names the marks without values, which the figure does not draw; empty if there are none.
std::string undrawn_marks(const StudyTables& tables, const std::vector<std::size_t>& drawn,
                          std::string_view reason) {
  std::vector<std::string> undrawn;
  for (const std::size_t mark : tables.set.times()) {
    if (std::ranges::find(drawn, mark) == drawn.end()) {
      undrawn.push_back(tables.set.measures[mark].id());
    }
  }
  return undrawn.empty() ? "" : fmt::format("Not drawn, as {}: {}.", reason, comma_list(undrawn));
}

std::string methods_explained(const StudyTables& tables, std::size_t methods,
                              const std::string& axis) {
  return fmt::format(
      "{} {} {} {}", participants_explained(tables, methods), estimates_explained(tables), axis,
      join_sentences(join_sentences("An interval may exceed the axis; the table has its limits.",
                                    censored_times_in_words(tables.set)),
                     undrawn_marks(tables, marks_over_all_scenes(tables),
                                   "no participant has a scene in which every method’s time was "
                                   "measured")));
}

std::string scenes_explained(const StudyTables& tables) {
  const std::string reference = baseline_label(tables);
  std::string text = fmt::format(
      "Points are the geometric means over participants of each one’s own time in per cent of {}’s "
      "in the same scene, with 95 % confidence intervals over participants; n is the number of "
      "participants "
      "with both times. ",
      reference);
  if (tables.set.scenes.size() > 1) {
    text += fmt::format(
        "“All scenes” is the geometric mean over the scenes in which every method’s time was "
        "measured, with its 95 % confidence interval over participants, {}. ",
        in_these_scenes(tables));
  }
  if (lacks_censored_times(tables)) {
    text +=
        "Hollow points leave out pairs in which a time was right-censored, which favours the "
        "method with the censored times. ";
  }
  return text + relative_axis_explained(tables) + " " +
         join_sentences("An interval may exceed the axis; times_by_scene.csv has its limits.",
                        undrawn_marks(tables, marks_in_scenes(tables),
                                      "no participant has both times in a scene"));
}

std::string meanings_of_marks(const StudyTables& tables) {
  std::string text;
  for (const std::size_t mark : tables.set.times()) {
    const Measure& measure = tables.set.measures[mark];
    const std::string meaning = meaning_of_mark(tables.set, measure.id());
    text += " " + (!meaning.empty() ? meaning
                   : measure.kind == MeasureKind::time
                       ? fmt::format("The mark {}: “{}”", measure.id(), measure.question.text)
                       : fmt::format("{}: {}.", measure.id(), measure.question.text));
  }
  return text;
}

std::string curve_explained(const StudyTables& tables, const Measure& mark) {
  const bool has_crosses = std::ranges::any_of(tables.survival, [&](const MarkSurvival& row) {
    return row.mark == mark.id() && row.curve.censored > 0;
  });
  return join_sentences(
      "Kaplan and Meier’s curve of each method, over all trials, on a logarithmic axis.",
      has_crosses ? "Crosses are right-censored trials." : "");
}

std::string unreached_html(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  std::string html;
  for (const std::string& sentence : unreached_in_words(tables.survival)) {
    html += paragraph_html(sentence);
  }
  for (const std::size_t mark : tables.set.marks()) {
    const Measure& measure = tables.set.measures[mark];
    html += figure_html(tables, content.figures, survival_figure_name(measure),
                        fmt::format("Trials without the mark {}, by time.", measure.id()),
                        curve_explained(tables, measure));
  }
  return html +
         table_html(tables, printed_time_to_mark(table_named(content.results, "time_to_mark")));
}

}  // namespace

std::string scenes_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  const PaperNotes paper = paper_notes(tables, content.published);
  std::string html = paragraph_html(paper.times_by_scene + meanings_of_marks(tables)) +
                     paragraph_html(paper.percentages);
  html += figure_html(tables, content.figures, "relative_times_by_scene",
                      fmt::format("Time relative to {} in each scene.", baseline_label(tables)),
                      scenes_explained(tables));
  for (const std::size_t mark : tables.set.times()) {
    html += table_html(tables, printed_times(tables, mark, content.published));
    if (tables.set.methods.size() > 1) {
      html += table_html(tables, printed_ratios_of_means(tables, mark, content.published));
    }
  }
  return html_section("Time in each scene", html);
}

std::string methods_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  const std::size_t methods = tables.set.methods.size();
  std::string html = paragraph_html(paper_notes(tables, content.published).times_by_method);
  html += figure_html(tables, content.figures, "relative_times",
                      fmt::format("Time relative to {}.", baseline_label(tables)),
                      methods_explained(tables, methods - 1, relative_axis_explained(tables)));
  html += figure_html(tables, content.figures, "times_in_seconds", "Time in seconds.",
                      methods_explained(tables, methods, "The axis is logarithmic."));
  html += table_html(tables, printed_geometric_means(tables, content.published));
  html += unreached_html(content);
  if (tables.incomplete_scenes > 0) {
    html += fmt::format(
        "<p>Left out, because not every method’s time was measured: {} of {} pairs of a "
        "participant and a scene, each mark counted separately.</p>\n",
        tables.incomplete_scenes,
        tables.set.participants.size() * tables.set.scenes.size() * tables.set.times().size());
  }
  return html_section("Time over all scenes", html);
}

std::string background_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  std::string text = background_in_words(content.background);
  std::string table;
  if (content.background.correlation) {
    text = join_sentences(text, paper_notes(tables, content.published).background);
    table = table_html(
        tables, printed_background(tables, table_named(content.results, "background_correlation")));
  }
  return html_section(
      "Background and speed-up",
      table_html(tables, printed_background_answers(content.background, content.published)) +
          fmt::format("<p>{}</p>\n", escape_html(text)) + table);
}

std::string ratings_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  const PaperNotes paper = paper_notes(tables, content.published);
  std::string html = paragraph_html(paper.ratings) +
                     paragraph_html(join_sentences(
                         "Means treat the steps of a scale as equal; the distribution, or each "
                         "participant’s mean, is given too, because they need not be.",
                         paper.means_of_ratings));
  for (const std::size_t rating : tables.set.ratings()) {
    const Measure& measure = tables.set.measures[rating];
    html += figure_html(tables, content.figures, rating_figure_name(measure),
                        fmt::format("Ratings, {}, of all scenes and participants.", measure.id()),
                        figure_explained(tables, measure));
    html += table_html(tables, printed_ratings(tables, rating));
  }
  return tables.set.ratings().empty() ? "" : html_section("Ratings", html);
}

std::string answers_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  const Table& answers = table_named(content.results, "answers_by_question");
  const Table& scores = table_named(content.results, "questionnaire_scores");
  if (answers.rows.empty() && scores.rows.empty()) {
    return "";
  }
  return html_section("Questionnaires", table_html(tables, printed_answers(answers)) +
                                            table_html(tables, printed_scores(scores)));
}

std::string comparisons_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  if (tables.set.methods.size() < 2) {
    return "";
  }
  return html_section(
      "Comparisons of methods",
      paragraph_html(plan_in_words(content.comparisons, tables.set.participants.size())) +
          tables_html(tables, primary_tables(content.results, content.comparisons)));
}

std::string sensitivity_section(const ReportContent& content) {
  const StudyTables& tables = content.tables;
  if (tables.set.methods.size() < 2) {
    return "";
  }
  return html_section(
      "Appendix: sensitivity analyses",
      paragraph_html(
          "The same comparisons by other analyses. Conclusions rest on the primary analyses; "
          "these show whether they depend on the choice of analysis.") +
          paragraph_html(models_in_words(content.comparisons.models)) +
          tables_html(tables, sensitivity_tables(content.results, content.comparisons)));
}

}  // namespace foveola::analysis
