#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string plan_in_words(const Comparisons& comparisons, std::size_t participants) {
  const study::AnalysisPlan& plan = comparisons.plan;
  std::string text =
      plan.primary.empty()
          ? "The protocol plans no comparison: all of these are exploratory, and their P-values "
            "are not adjusted for their number."
          : fmt::format(
                "The protocol planned {} before there were data, at a level of {:g} for all "
                "of them together (Holm); everything else is exploratory, and not adjusted.",
                counted(plan.primary.size(), "primary comparison"), plan.alpha);
  if (plan.participants && static_cast<std::size_t>(*plan.participants) != participants) {
    text += fmt::format(" It planned {}; {} analysed.",
                        counted(static_cast<std::size_t>(*plan.participants), "participant"),
                        participants == 1 ? "1 is" : fmt::format("{} are", participants));
  }
  return text;
}

std::string models_in_words(const FittedModels& models) {
  if (models.versions.empty()) {
    return fmt::format("No model was fitted by R{}{}.", models.missing.empty() ? "" : ": ",
                       models.missing);
  }
  std::vector<std::string> versions;
  for (const auto& [name, version] : models.versions) {
    versions.push_back(fmt::format("{} {}", name, version));
  }
  return fmt::format("Models were fitted by {}; models.R has the formulas.", listed(versions));
}

std::string tables_html(const StudyTables& tables, const std::vector<PrintedTable>& printed) {
  std::string html;
  for (const PrintedTable& table : printed) {
    if (!table.rows.empty()) {
      html += html_of(table, data_notice(tables));
    }
  }
  return html;
}

}  // namespace

std::string comparisons_section(const StudyTables& tables, const Comparisons& comparisons) {
  if (tables.set.methods.size() < 2) {
    return "";
  }
  return html_section("Comparisons of methods",
                      paragraph_html(plan_in_words(comparisons, tables.set.participants.size())) +
                          tables_html(tables, {printed_primary(comparisons, true),
                                               printed_primary(comparisons, false)}));
}

std::string sensitivity_section(const StudyTables& tables, const Comparisons& comparisons) {
  if (tables.set.methods.size() < 2) {
    return "";
  }
  return html_section(
      "Appendix: sensitivity analyses",
      paragraph_html(
          "The same comparisons by other means. Conclusions rest on the primary analyses; "
          "here they are seen to depend, or not, on how the data are analysed.") +
          paragraph_html(models_in_words(comparisons.models)) +
          tables_html(tables, sensitivity_tables(comparisons)));
}

}  // namespace foveola::analysis
