#include <fmt/format.h>

#include "analysis/dataset/wording.h"
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

}  // namespace

std::string background_section(const StudyTables& tables, const Background& background) {
  const std::string html =
      fmt::format("<p>{}</p>\n", escape_html(background_scale_in_words(background.scale)));
  return html_section(
      "Background and speed-up",
      background.scale.questions.empty()
          ? html
          : html + html_of(printed_background(tables, background), data_notice(tables)));
}

}  // namespace foveola::analysis
