#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string background_scale_in_words(const BackgroundScale& scale) {
  if (scale.questions.empty()) {
    return "The study asked no background question on a scale of five points, so there is nothing "
           "to correlate.";
  }
  return fmt::format("Background is the mean of the answers to {}{}.",
                     scale.as_published ? "" : "every question on a scale of five points: ",
                     listed(scale.questions));
}

}  // namespace

std::string background_section(const StudyTables& tables, const Background& background,
                               const std::optional<PublishedStudy>& published) {
  std::string text = background_scale_in_words(background.scale);
  std::string table;
  if (!background.scale.questions.empty()) {
    const std::string paper = paper_notes(tables, published).background;
    text += paper.empty() ? "" : " " + paper;
    table = html_of(printed_background(tables, background, published), data_notice(tables));
  }
  return html_section(
      "Background and speed-up",
      html_of(printed_background_answers(background, published), data_notice(tables)) +
          fmt::format("<p>{}</p>\n", escape_html(text)) + table);
}

}  // namespace foveola::analysis
