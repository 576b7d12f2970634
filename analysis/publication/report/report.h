// Writes the study's report: one HTML file that needs no network.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "analysis/publication/figures/figures.h"
#include "analysis/tables/table.h"
#include "study/record/maintain/maintenance.h"

namespace foveola::analysis {

struct ReportContent {
  const StudyTables& tables;
  const Background& background;
  const std::vector<Table>& results;
  const Comparisons& comparisons;
  const study::DataQualityRecords& quality;
  const DataQualityReport& checks;
  const std::vector<Figure>& figures;
  const std::optional<PublishedStudy>&
      published;               ///< The published study to compare with; see published_study_for.
  const std::string& methods;  ///< The text of methods_paragraph.
  const std::optional<study::Verification>& record;  ///< The verification, if there is a file.
};

/// Returns the whole page. It names omitted data with the reasons, and defines every number. If the
/// data are not people's, its top and each caption say so.
std::string report_html(const ReportContent& content);

}  // namespace foveola::analysis
