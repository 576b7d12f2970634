#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string background_in_words(const Background& background) {
  if (background.scale.empty()) {
    return "The protocol states no scale of background ([analysis] background), so nothing is "
           "correlated with it.";
  }
  if (!background.correlation) {
    return "The protocol plans no comparison of times with the baseline, with which background "
           "could be correlated.";
  }
  return fmt::format(
      "Background is the mean of the answers to {}, as the protocol states. Its correlation with "
      "the speed-up in the first planned comparison of times is the only one that is tested.",
      listed(background.scale));
}

}  // namespace

std::string background_section(const StudyTables& tables, const Background& background,
                               const std::optional<PublishedStudy>& published) {
  std::string text = background_in_words(background);
  std::string table;
  if (background.correlation) {
    text = joined(text, paper_notes(tables, published).background);
    table = html_of(printed_background(tables, background), data_notice(tables));
  }
  return html_section(
      "Background and speed-up",
      html_of(printed_background_answers(background, published), data_notice(tables)) +
          fmt::format("<p>{}</p>\n", escape_html(text)) + table);
}

}  // namespace foveola::analysis
