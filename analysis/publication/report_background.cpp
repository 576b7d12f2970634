#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

std::string background_scale_in_words(const BackgroundScale& scale) {
  if (scale.questions.empty()) {
    return "The study asked no background question on a scale of five points, so there is nothing "
           "to correlate.";
  }
  const std::string questions = listed(scale.questions);
  return scale.as_published
             ? fmt::format(
                   "Background is the mean of the answers to {}, as in the published "
                   "study, which correlated it with OD − FV.",
                   questions)
             : fmt::format(
                   "Background is the mean of the answers to every five-point question "
                   "({}): the study did not ask both of the published study’s, "
                   "graphics_3d and offline_rendering.",
                   questions);
}

std::string coefficient(const std::optional<Correlation>& found) {
  return found ? with_interval(Estimate{found->n, found->r, found->interval}, 2) : "–";
}

std::string p_text(const std::optional<Correlation>& found) {
  return found ? p_value(found->p) : "–";
}

std::vector<std::string> correlation_row(const BackgroundCorrelation& row,
                                         const std::string& reference) {
  const std::string name =
      fmt::format("{} − {}, {}", reference, method_label(row.method), name_of(row.mark));
  const std::string n = std::to_string(row.participants);
  return {name,
          n,
          coefficient(row.pearson),
          row.pearson ? fixed(row.pearson->t, 2) : "–",
          p_text(row.pearson),
          coefficient(row.spearman),
          p_text(row.spearman) + (row.spearman && row.spearman->exact ? " (exact)" : "")};
}

std::string background_answers_table(const StudyTables& tables) {
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Participants’ background.") +
      "Table 1 of the published study: mean, standard deviation (sd) and median of "
      "the answers that are numbers.";
  table.columns = {"Question", "n", "mean", "sd", "median", "missing"};
  for (const QuestionAnswers& row : tables.background_answers) {
    table.rows.push_back({row.question, std::to_string(row.answers.n), fixed(row.answers.mean, 2),
                          fixed(row.answers.standard_deviation, 2), fixed(row.answers.median, 1),
                          std::to_string(row.missing)});
  }
  return table.rows.empty() ? "" : render(table);
}

}  // namespace

std::string background_section(const StudyTables& tables) {
  std::string html =
      background_answers_table(tables) +
      fmt::format("<p>{}</p>\n", escape_html(background_scale_in_words(tables.background)));
  if (tables.background.questions.empty()) {
    return html_section("Background and speed-up", html);
  }
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Correlation of background with the seconds saved.") +
      "Pearson’s r of the values and Spearman’s ρ of their ranks, with 95 % intervals. Seconds "
      "saved are each participant’s mean over scenes; P is two-sided. A dash: not defined, because "
      "of fewer than three participants or constant values.";
  table.columns = {"Seconds saved", "n", "r [95 %]", "t", "P", "ρ [95 %]", "P, ρ"};
  for (const BackgroundCorrelation& row : tables.background_correlations) {
    table.rows.push_back(correlation_row(row, baseline_label(tables)));
  }
  return html_section("Background and speed-up", html + render(table));
}

}  // namespace foveola::analysis
