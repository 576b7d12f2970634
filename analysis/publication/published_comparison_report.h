// A study beside the published one, as a page and a table, for `study simulate --report`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/koskela2018/published_comparison.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// The comparison with one row per number of the paper and reading.
Table published_comparison_table(const StudyTables& tables,
                                 const std::vector<ComparedNumber>& numbers);

/// The comparison as a page of its own.
std::string comparison_html(const StudyTables& tables, const std::vector<ComparedNumber>& numbers);

/// The main numbers for the terminal, each line ended by a line break.
std::string comparison_summary(const StudyTables& tables,
                               const std::vector<ComparedNumber>& numbers);

/// Reads a study's file and writes published_comparison.html and .csv to `folder`, which is made if
/// its parent exists. Returns lines for the terminal, each ended by a line break. Throws Error as
/// analyze_study does.
std::string report_published_comparison(const std::filesystem::path& database,
                                        const std::filesystem::path& folder);

}  // namespace foveola::analysis
