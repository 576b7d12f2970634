#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/survival_output.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

/// The end of a sentence: what the hollow points are, if there are any.
std::string points_in_words(const StudyTables& tables) {
  return tables.set.participants.size() > most_dots ? "."
                                                    : "; each hollow point is one participant.";
}

std::string meanings_of_marks(const StudyTables& tables) {
  std::string text;
  for (const std::size_t mark : tables.set.times()) {
    const Measure& measure = tables.set.measures[mark];
    const std::string meaning = meaning_of_mark(measure.id());
    text += " " + (meaning.empty()
                       ? fmt::format("The mark {}: “{}”", measure.id(), measure.question.text)
                       : meaning);
  }
  return text;
}

/// The times with trials in which a mark was never reached.
std::string unreached_html(const StudyTables& tables, const std::vector<Figure>& figures) {
  std::string html;
  for (const std::string& sentence : unreached_in_words(tables.survival)) {
    html += paragraph_html(sentence);
  }
  for (const std::size_t mark : tables.set.times()) {
    const Measure& measure = tables.set.measures[mark];
    html += figure_html(tables, figures, survival_figure_name(measure),
                        fmt::format("Trials without the mark {}, by time.", measure.id()),
                        "Kaplan and Meier’s curve of each method, over all trials.");
  }
  return html + html_of(printed_time_to_mark(tables), data_notice(tables));
}

}  // namespace

std::string scenes_section(const StudyTables& tables) {
  const PaperNotes paper = paper_notes(tables.set);
  std::string html = paragraph_html(paper.times_by_scene + meanings_of_marks(tables)) +
                     paragraph_html(paper.percentages);
  for (const std::size_t mark : tables.set.times()) {
    html += html_of(printed_times(tables, mark), data_notice(tables));
    if (tables.set.methods.size() > 1) {
      html += html_of(printed_ratios_of_means(tables, mark), data_notice(tables));
    }
  }
  return html_section("Time in each scene", html);
}

std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::vector<PublishedMean>& published) {
  const std::string what_is_drawn =
      "Geometric mean over scenes and 95 % interval over participants" + points_in_words(tables);
  const std::string off_the_axis = " An interval may run off the axis; the table has it.";
  std::string html = paragraph_html(paper_notes(tables.set).times_by_method);
  html += figure_html(tables, figures, "relative_times",
                      fmt::format("Time relative to {}.", baseline_label(tables)),
                      what_is_drawn + " The dark vertical line is no change." + off_the_axis);
  html += figure_html(tables, figures, "times_in_seconds", "Time in seconds.",
                      what_is_drawn + off_the_axis);
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
