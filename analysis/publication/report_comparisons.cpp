#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string plan_in_words(const Comparisons& comparisons, std::size_t participants) {
  const study::AnalysisPlan& plan = comparisons.plan;
  std::string text =
      plan.primary.empty()
          ? "The protocol plans no comparison: all of these are exploratory, and adjusted within "
            "their measure."
          : fmt::format(
                "The protocol planned {} before there were data, at a level of {:g} for all "
                "of them together (Holm); everything else is exploratory, and adjusted "
                "within its measure.",
                counted(plan.primary.size(), "primary comparison"), plan.alpha);
  if (plan.participants && static_cast<std::size_t>(*plan.participants) != participants) {
    text += fmt::format(" It planned {}; {} analysed.",
                        counted(static_cast<std::size_t>(*plan.participants), "participant"),
                        participants == 1 ? "1 is" : fmt::format("{} are", participants));
  }
  return text;
}

}  // namespace

std::string comparisons_section(const StudyTables& tables, const Comparisons& comparisons) {
  if (tables.set.methods.size() < 2) {
    return "";
  }
  std::string html = fmt::format(
      "<p>{}</p>\n", escape_html(plan_in_words(comparisons, tables.set.participants.size())));
  for (const PrintedTable& table : comparison_pages(comparisons)) {
    html += html_of(table, data_notice(tables));
  }
  return html_section("Comparisons of methods", html);
}

}  // namespace foveola::analysis
