#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string figure_explained(const Measure& measure) {
  const std::string scale = study::scale_in_words(measure);
  return measure.points().empty()
             ? fmt::format(
                   "Open dots: each participant’s mean, {}, joined by thin lines, over the "
                   "scenes rated with every method. Filled dots: their mean and its 95 % "
                   "interval, which may run off the axis.",
                   scale)
             : fmt::format(
                   "Bars: the share of each answer, {}, with its count. At the right: mean "
                   "± standard deviation.",
                   scale);
}

}  // namespace

std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures) {
  const PaperNotes paper = paper_notes(tables.set);
  std::string html =
      paragraph_html(paper.ratings) +
      paragraph_html(joined("Means treat the steps of a scale as equal; the distribution, or each "
                            "participant’s mean, is given too, because they need not be.",
                            paper.means_of_ratings));
  for (const std::size_t rating : tables.set.ratings()) {
    const Measure& measure = tables.set.measures[rating];
    html += figure_html(tables, figures, rating_figure_name(measure),
                        fmt::format("Ratings, {}, of all scenes and participants.", measure.id()),
                        figure_explained(measure));
    html += html_of(printed_ratings(tables, rating), data_notice(tables));
  }
  return tables.set.ratings().empty() ? "" : html_section("Ratings", html);
}

std::string answers_section(const StudyTables& tables, const Table& answers, const Table& scores) {
  if (answers.rows.empty() && scores.rows.empty()) {
    return "";
  }
  return html_section("Questionnaires", html_of(printed_answers(answers), data_notice(tables)) +
                                            html_of(printed_scores(scores), data_notice(tables)));
}

}  // namespace foveola::analysis
