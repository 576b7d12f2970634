#include "analysis/publication/report.h"

#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

/// The crossed model's ratio, for scenes like these; empty where it is not the primary analysis.
std::string for_other_scenes(const Comparisons& comparisons, const MethodTimes& times,
                             const std::string& reference) {
  for (const MethodComparison& row : comparisons.methods) {
    if (row.measure == times.mark && row.method == times.method && row.reference == reference &&
        row.primary && row.primary->kind == AnalysisKind::crossed_model) {
      const PrimaryResult& result = *row.primary;
      Estimate percent{.value = 100.0 * std::exp(result.estimate)};
      if (result.interval) {
        percent.interval = {100.0 * std::exp(result.interval->low),
                            100.0 * std::exp(result.interval->high)};
      }
      return fmt::format("; in scenes like these, {} %", with_interval(percent, 1));
    }
  }
  return "";
}

std::string findings_html(const StudyTables& tables, const Comparisons& comparisons) {
  std::string items;
  for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
    for (const std::size_t mark : tables.set.times()) {
      const MethodTimes& times = tables.method_times_of(mark, method);
      if (times.percent_of_baseline) {
        items += fmt::format(
            "<li>{} took <strong>{} %</strong> of {}’s time until {} {}{}.</li>\n",
            escape_html(method_label(times.method)),
            escape_html(with_interval(times.percent_of_baseline, 1)),
            escape_html(baseline_label(tables)), escape_html(moment_of(tables.set.measures[mark])),
            in_these_scenes(tables),
            escape_html(for_other_scenes(comparisons, times, tables.set.methods[baseline])));
      }
    }
  }
  return items.empty() ? ""
                       : "<ul class=\"findings\">\n" + items +
                             "</ul>\n<p>Geometric means over scenes, with 95 % intervals over "
                             "participants in brackets; in scenes like these, with intervals over "
                             "participants and scenes (crossed mixed model).</p>\n";
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
  const StudyTables& tables = content.tables;
  return report_page(
      tables, "Foveola study report",
      record_flags(content.record) + data_quality_flags(tables, content.checks) +
          findings_html(tables, content.comparisons) +
          scenes_section(tables, content.figures, content.published) +
          methods_section(tables, content.figures, content.published) +
          ratings_section(tables, content.figures, content.published) +
          comparisons_section(tables, content.comparisons) +
          answers_section(tables, content.answers, content.scores) +
          background_section(tables, content.background, content.published) +
          data_quality_section(tables, content.checks, content.quality, content.published) +
          record_section(content.record) + exclusions_section(tables) + amended_section(tables) +
          methods_text_section(content.methods) + sensitivity_section(tables, content.comparisons) +
          definitions_section(tables) + citation_section());
}

}  // namespace foveola::analysis
