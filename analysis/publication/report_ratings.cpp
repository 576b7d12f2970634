#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {

std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures) {
  HtmlTable table;
  table.caption_html = caption_start(tables, "Artifact ratings.") +
                       escape_html(fmt::format("Number of answers {}.{}",
                                               points_in_brackets(tables.set.rating_scale),
                                               notes_on(tables.set.rating_scale)));
  table.groups = {{"", 1}, {"Answers", 6}, {"Summary", 3}};
  table.columns = {"Method", "1", "2", "3", "4", "5", "missing", "mean", "sd", "median"};
  for (const MethodRatings& ratings : tables.ratings) {
    std::vector<std::string> row = {method_label(ratings.method)};
    for (const int count : ratings.counts) {
      row.push_back(std::to_string(count));
    }
    row.push_back(std::to_string(ratings.missing));
    row.push_back(fixed(ratings.rating.mean, 2));
    row.push_back(fixed(ratings.rating.standard_deviation, 2));
    row.push_back(fixed(ratings.rating.median, 1));
    table.rows.push_back(std::move(row));
  }
  const std::string intro =
      "<p>Fig. 6 of the published study: how disturbing artifacts were in the areas other than "
      "the chosen object. Means treat the steps of the scale as equal, as the "
      "published study did; the distribution is given too, because they need not be.</p>\n";
  return html_section(
      "Artifacts in other areas",
      intro +
          figure_html(tables, figures, "figure6_artifact_ratings",
                      "Artifact ratings, all scenes and participants.",
                      fmt::format("Bars: the share of each answer, {}, with its count. At the "
                                  "right: mean ± standard deviation.",
                                  points_in_words(tables.set.rating_scale))) +
          render(table));
}

}  // namespace foveola::analysis
