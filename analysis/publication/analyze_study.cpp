#include "analysis/publication/analyze_study.h"

#include <fmt/format.h>

#include "analysis/publication/figures.h"
#include "analysis/publication/output_folder.h"
#include "analysis/publication/published_means.h"
#include "analysis/publication/report.h"
#include "analysis/publication/summary.h"
#include "analysis/publication/table_files.h"
#include "analysis/publication/wording.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

std::vector<std::string> warnings_about(const StudyTables& tables) {
  std::vector<std::string> warnings;
  if (const std::string warning = data_warning(tables); !warning.empty()) {
    warnings.push_back(warning);
  }
  if (tables.set.methods.size() < 2) {
    warnings.emplace_back("The protocol has one method: nothing can be compared.");
  }
  if (tables.set.participants.size() < 2) {
    warnings.emplace_back("One participant: no standard deviations and no intervals.");
  }
  if (const std::size_t count = tables.set.exclusions.size(); count > 0) {
    warnings.push_back(fmt::format(
        "{} left out: exclusions.csv says which and why.",
        count == 1 ? "One session or value is" : fmt::format("{} sessions or values are", count)));
  }
  return warnings;
}

/// The report comes last, so that it never stands beside tables older than itself.
std::vector<TextFile> files_of(const StudyTables& tables) {
  const std::vector<Figure> figures = draw_figures(tables);
  const std::vector<PublishedMean> published =
      read_published_means(resource_folder() / "data" / "koskela2018" / "mean_percent_of_od.csv");
  std::vector<TextFile> files = table_files(tables);
  for (const Figure& figure : figures) {
    files.push_back({figure.name + ".svg", figure.svg});
  }
  files.push_back({"report.html", report_html(tables, figures, published)});
  return files;
}

}  // namespace

AnalysisOutput analyze_records(const study::StudyRecords& records, const fs::path& folder) {
  AnalysisOutput output;
  output.tables = tabulate_study(records);
  output.summary = terminal_summary(output.tables);
  output.warnings = warnings_about(output.tables);
  const std::vector<TextFile> files = files_of(output.tables);
  make_output_folder(folder);
  for (const TextFile& file : files) {
    write_file(folder / file.name, file.content);
    output.files.push_back(folder / file.name);
  }
  output.report = output.files.back();
  return output;
}

AnalysisOutput analyze_study(const fs::path& database, const fs::path& folder) {
  return analyze_records(study::read_study(database), folder);
}

}  // namespace foveola::analysis
