// The sections of the report, one after the other; report.h puts them on a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/comparisons.h"
#include "analysis/publication/data_quality_checks.h"
#include "analysis/publication/figures.h"
#include "analysis/publication/published_means.h"
#include "analysis/publication/study_tables.h"
#include "study/record/maintenance.h"

namespace foveola::analysis {

// Each is the HTML of a section, with every text of the study's escaped.

/// Table 2, in both readings of its percentages.
std::string scenes_section(const StudyTables& tables);

/// Fig. 5.
std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::vector<PublishedMean>& published);

/// Fig. 6.
std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures);

/// Planned and exploratory tests; empty for a single method.
std::string comparisons_section(const StudyTables& tables, const Comparisons& comparisons);

/// The P-value of background.
std::string background_section(const StudyTables& tables);

/// That the study's file is not what was written, for the top of the report; empty if it is.
std::string record_flags(const std::optional<study::Verification>& record);

/// How the study's file was verified, and what was found; no file: that there was none.
std::string record_section(const std::optional<study::Verification>& record);

/// Which data-quality limits were missed, for the top of the report; empty if nothing.
std::string data_quality_flags(const StudyTables& tables, const DataQualityReport& report);

/// Checks, latency (Fig. 7), attempts, and the floor of reaction times.
std::string data_quality_section(const StudyTables& tables, const DataQualityReport& report,
                                 const study::DataQualityRecords& quality);

/// The sessions that went by an amended protocol, and which of its keys had changed.
std::string amended_section(const StudyTables& tables);

/// What no number uses, and why.
std::string exclusions_section(const StudyTables& tables);

/// What every number means.
std::string definitions_section(const StudyTables& tables);

}  // namespace foveola::analysis
