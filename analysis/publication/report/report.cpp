#include "analysis/publication/report/report.h"

#include <fmt/format.h>

#include "analysis/publication/report/report_parts.h"
#include "analysis/publication/report/report_sections.h"
#include "analysis/publication/report/summary.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

std::string findings_html(const ReportContent& content) {
  std::string items;
  for (const Headline& finding : headlines(content.tables, content.comparisons)) {
    items += fmt::format("<li>{} <strong>{}</strong> {}.</li>\n", escape_html(finding.before),
                         escape_html(finding.value), escape_html(finding.after));
  }
  return items.empty() ? ""
                       : "<ul class=\"findings\">\n" + items +
                             "</ul>\n<p>The primary analysis of each comparison, with its 95 % "
                             "confidence interval in brackets.</p>\n";
}

std::string methods_text_section(const std::string& methods) {
  return html_section("Methods paragraph",
                      "<p>Written from the protocol, to be edited for a paper.</p>\n<blockquote>" +
                          escape_html(methods) + "</blockquote>\n");
}

std::string citation_section() {
  return html_section(
      "How to cite",
      "<p>M. K. Koskela, K. V. Immonen, T. T. Viitanen, P. O. Jääskeläinen, J. I. Multanen, "
      "J. H. Takala. “Instantaneous foveated preview for progressive Monte Carlo rendering.” "
      "<cite>Computational Visual Media</cite> 4(3), 267–276, 2018. "
      "<a "
      "href=\"https://doi.org/10.1007/s41095-018-0113-0\">doi:10.1007/s41095-018-0113-0</a></p>\n"
      "<p>Name the protocol and its SHA-256 with every result, so that others can run the same "
      "study.</p>\n");
}

}  // namespace

std::string report_html(const ReportContent& content) {
  return report_page(
      content.tables, "Foveola study report",
      record_flags(content) + data_quality_flags(content) + findings_html(content) +
          scenes_section(content) + methods_section(content) + ratings_section(content) +
          comparisons_section(content) + answers_section(content) + background_section(content) +
          data_quality_section(content) + record_section(content) + exclusions_section(content) +
          amended_section(content) + methods_text_section(content.methods) +
          sensitivity_section(content) + definitions_section(content) + citation_section());
}

}  // namespace foveola::analysis
