#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

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
      "{} Filled points are the means over n participants, with 95 % intervals over participants, "
      "{}, which may run off the axis.",
      participants, in_these_scenes(tables));
}

std::string figure_explained(const StudyTables& tables, const Measure& measure) {
  return measure.points().empty() ? means_explained(tables, measure) : bars_explained(measure);
}

}  // namespace

std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::optional<PublishedStudy>& published) {
  const PaperNotes paper = paper_notes(tables, published);
  std::string html =
      paragraph_html(paper.ratings) +
      paragraph_html(joined("Means treat the steps of a scale as equal; the distribution, or each "
                            "participant’s mean, is given too, because they need not be.",
                            paper.means_of_ratings));
  for (const std::size_t rating : tables.set.ratings()) {
    const Measure& measure = tables.set.measures[rating];
    html += figure_html(tables, figures, rating_figure_name(measure),
                        fmt::format("Ratings, {}, of all scenes and participants.", measure.id()),
                        figure_explained(tables, measure));
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
