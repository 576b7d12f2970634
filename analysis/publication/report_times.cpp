#include <algorithm>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/scene_figure.h"
#include "analysis/publication/survival_output.h"
#include "analysis/publication/time_figures.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

/// What the points and lines of participants are in a figure of so many methods.
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
      "Filled points are the geometric means over participants, with 95 % intervals over "
      "participants, {}.",
      in_these_scenes(tables));
}

std::string relative_axis_explained(const StudyTables& tables) {
  return fmt::format(
      "The axis is logarithmic: per cent of {}’s time below, and above how many times as fast that "
      "is, 2× at 50 %. The dark vertical line is no change.",
      baseline_label(tables));
}

/// The marks that a figure of `drawn` ones leaves out; empty if there are none.
std::string undrawn_marks(const StudyTables& tables, const std::vector<std::size_t>& drawn,
                          std::string_view reason) {
  std::vector<std::string> undrawn;
  for (const std::size_t mark : tables.set.times()) {
    if (std::find(drawn.begin(), drawn.end(), mark) == drawn.end()) {
      undrawn.push_back(tables.set.measures[mark].id());
    }
  }
  return undrawn.empty() ? "" : fmt::format("Not drawn, as {}: {}.", reason, listed(undrawn));
}

/// The explanation of relative_times or times_in_seconds, which differ by their axis.
std::string methods_explained(const StudyTables& tables, std::size_t methods,
                              const std::string& axis) {
  return fmt::format("{} {} {} {}", participants_explained(tables, methods),
                     estimates_explained(tables), axis,
                     joined(joined("An interval may run off the axis; the table has its ends.",
                                   censored_times_in_words(tables.set)),
                            undrawn_marks(tables, marks_over_all_scenes(tables),
                                          "nobody has a scene in which every method’s time was "
                                          "measured")));
}

std::string scenes_explained(const StudyTables& tables) {
  const std::string reference = baseline_label(tables);
  std::string text = fmt::format(
      "Points are the geometric means over participants of each one’s own time in per cent of {}’s "
      "in the same scene, with 95 % intervals over participants; n is the number of participants "
      "with both times. ",
      reference);
  if (tables.set.scenes.size() > 1) {
    text += fmt::format(
        "“All scenes” is the geometric mean over the scenes in which every method’s time was "
        "measured, with its 95 % interval over participants, {}. ",
        in_these_scenes(tables));
  }
  if (lacks_censored_times(tables)) {
    text +=
        "Hollow points leave out pairs in which a time was right-censored, which favours the "
        "method whose time ran out. ";
  }
  return text + relative_axis_explained(tables) + " " +
         joined("An interval may run off the axis; times_by_scene.csv has its ends.",
                undrawn_marks(tables, marks_in_scenes(tables), "nobody has both times in a scene"));
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
  const bool has_crosses = std::any_of(
      tables.survival.begin(), tables.survival.end(),
      [&](const MarkSurvival& row) { return row.mark == mark.id() && row.curve.censored > 0; });
  return joined("Kaplan and Meier’s curve of each method, over all trials, on a logarithmic axis.",
                has_crosses ? "Crosses are right-censored trials." : "");
}

/// The times with trials in which a mark was never reached.
std::string unreached_html(const StudyTables& tables, const std::vector<Figure>& figures) {
  std::string html;
  for (const std::string& sentence : unreached_in_words(tables.survival)) {
    html += paragraph_html(sentence);
  }
  for (const std::size_t mark : tables.set.marks()) {
    const Measure& measure = tables.set.measures[mark];
    html += figure_html(tables, figures, survival_figure_name(measure),
                        fmt::format("Trials without the mark {}, by time.", measure.id()),
                        curve_explained(tables, measure));
  }
  return html + html_of(printed_time_to_mark(tables), data_notice(tables));
}

}  // namespace

std::string scenes_section(const StudyTables& tables, const std::vector<Figure>& figures,
                           const std::optional<PublishedStudy>& published) {
  const PaperNotes paper = paper_notes(tables, published);
  std::string html = paragraph_html(paper.times_by_scene + meanings_of_marks(tables)) +
                     paragraph_html(paper.percentages);
  html += figure_html(tables, figures, "relative_times_by_scene",
                      fmt::format("Time relative to {} in each scene.", baseline_label(tables)),
                      scenes_explained(tables));
  for (const std::size_t mark : tables.set.times()) {
    html += html_of(printed_times(tables, mark, published), data_notice(tables));
    if (tables.set.methods.size() > 1) {
      html += html_of(printed_ratios_of_means(tables, mark, published), data_notice(tables));
    }
  }
  return html_section("Time in each scene", html);
}

std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::optional<PublishedStudy>& published) {
  const std::size_t methods = tables.set.methods.size();
  std::string html = paragraph_html(paper_notes(tables, published).times_by_method);
  html += figure_html(tables, figures, "relative_times",
                      fmt::format("Time relative to {}.", baseline_label(tables)),
                      methods_explained(tables, methods - 1, relative_axis_explained(tables)));
  html += figure_html(tables, figures, "times_in_seconds", "Time in seconds.",
                      methods_explained(tables, methods, "The axis is logarithmic."));
  html += html_of(printed_geometric_means(tables, published), data_notice(tables));
  html += unreached_html(tables, figures);
  if (tables.incomplete_scenes > 0) {
    html += fmt::format(
        "<p>Left out here, because not every method’s time was measured: {} of {} pairs of a "
        "participant and a scene, each mark counted apart.</p>\n",
        tables.incomplete_scenes,
        tables.set.participants.size() * tables.set.scenes.size() * tables.set.times().size());
  }
  return html_section("Time over all scenes", html);
}

}  // namespace foveola::analysis
