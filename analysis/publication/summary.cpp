#include "analysis/publication/summary.h"

#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/headline.h"
#include "analysis/publication/printed_results.h"
#include "renderer/base/utf8.h"

namespace foveola::analysis {
namespace {

/// As it is on the terminal: without the note, which the report has.
std::string block(const StudyTables& tables, PrintedTable table) {
  table.note.clear();
  return fmt::format("\n{}", plain_text_of(table, data_notice(tables)));
}

}  // namespace

std::string terminal_summary(const StudyTables& tables, const Comparisons& comparisons,
                             const Background& background,
                             const std::optional<PublishedStudy>& published) {
  std::string text = fmt::format(
      "{}: {}, {}, {}\n", printable(tables.protocol_name), participants_in_words(tables),
      counted(tables.set.scenes.size(), "scene"), counted(tables.set.methods.size(), "method"));
  for (const Headline& finding : headlines(tables, comparisons)) {
    text += fmt::format("  {}.\n", printable(finding.sentence()));
  }
  for (const std::size_t mark : tables.set.times()) {
    text += block(tables, printed_times(tables, mark, published));
  }
  text += fmt::format(
      "  Mean ± standard deviation; % of each participant's own {} time. The last row: geometric\n"
      "  mean over scenes with a 95 % interval over participants.\n",
      printable(method_label(tables.set.methods[baseline])));
  if (const std::string censored = censored_times_in_words(tables.set); !censored.empty()) {
    text += fmt::format("  {}\n", printable(censored));
  }
  if (published) {
    text += block(tables, printed_geometric_means(tables, published));
  }
  for (const std::size_t rating : tables.set.ratings()) {
    const Measure& measure = tables.set.measures[rating];
    PrintedTable table = printed_ratings(tables, rating);
    table.title = fmt::format("Ratings: {}, {}", measure.id(), study::scale_in_words(measure));
    text += block(tables, std::move(table));
  }
  if (published) {
    text += block(tables, printed_background_answers(background, published));
  }
  if (background.correlation) {
    PrintedTable table = printed_background(tables, background);
    table.title = fmt::format("Background ({}) against speed-up", listed(background.scale));
    text += block(tables, std::move(table));
  }
  return text;
}

}  // namespace foveola::analysis
