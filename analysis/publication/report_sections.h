// The sections of the report, one after the other; report.h puts them on a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/publication/data_quality_checks.h"
#include "analysis/publication/figures.h"
#include "analysis/tables/table.h"
#include "study/record/maintenance.h"

namespace foveola::analysis {

// Each function returns the HTML of a section, with every text from the study escaped. `published`
// is what stands beside the study; empty for one that does not measure what was published.

/// The times in each scene, in both readings of their percentages, with their figure.
std::string scenes_section(const StudyTables& tables, const std::vector<Figure>& figures,
                           const std::optional<PublishedStudy>& published);

/// The times over all scenes, with their figures.
std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::optional<PublishedStudy>& published);

/// Every rating in numbers; empty if there is none.
std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::optional<PublishedStudy>& published);

/// The tables answers_by_question and questionnaire_scores; empty if nothing was asked.
std::string answers_section(const StudyTables& tables, const Table& answers, const Table& scores);

/// The primary analyses of planned and exploratory comparisons; empty for a single method.
std::string comparisons_section(const StudyTables& tables, const Comparisons& comparisons);

/// All other tests of the same comparisons; empty for a single method.
std::string sensitivity_section(const StudyTables& tables, const Comparisons& comparisons);

/// The correlation of background with speed-up, and its P-value.
std::string background_section(const StudyTables& tables, const Background& background,
                               const std::optional<PublishedStudy>& published);

/// The warning that the study's file failed its verification, for the top of the report; empty if
/// it passed.
std::string record_flags(const std::optional<study::Verification>& record);

/// How the study's file was verified, and the findings, or that there was no file.
std::string record_section(const std::optional<study::Verification>& record);

/// The data-quality limits that were missed, for the top of the report; empty if none.
std::string data_quality_flags(const StudyTables& tables, const DataQualityReport& report);

/// Checks, latency (Fig. 7), attempts, and the floor of reaction times.
std::string data_quality_section(const StudyTables& tables, const DataQualityReport& report,
                                 const study::DataQualityRecords& quality,
                                 const std::optional<PublishedStudy>& published);

/// The sessions that followed an amended protocol, and which of its keys had changed.
std::string amended_section(const StudyTables& tables);

/// The excluded sessions and values, with the reasons.
std::string exclusions_section(const StudyTables& tables);

/// The definitions of all numbers.
std::string definitions_section(const StudyTables& tables);

}  // namespace foveola::analysis
