// Reports a study beside the published one, as a page and a table, for `study simulate --report`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_comparison.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Returns the comparison, with a row per number of the paper and reading.
Table published_comparison_table(const StudyTables& tables,
                                 const std::vector<ComparedNumber>& numbers);

/// Returns the comparison as a page of its own.
std::string comparison_html(const StudyTables& tables, const std::vector<ComparedNumber>& numbers);

/// Returns the main numbers for the terminal, in lines that end with a line break.
std::string comparison_summary(const StudyTables& tables,
                               const std::vector<ComparedNumber>& numbers);

/// Reads a study's file and writes published_comparison.html, .csv and .json to `folder`, which is
/// made if its parent exists. Returns lines for the terminal. Throws Error as analyze_study does.
std::string report_published_comparison(const std::filesystem::path& database,
                                        const std::filesystem::path& folder);

/// Returns the row of the published Table 2 for a scene: its name, then the mean and deviation of
/// each of the `methods`. Empty without `published`, for a scene that is neither published nor a
/// counterpart, or if times are not relative to OD's.
std::optional<std::vector<std::string>> published_row(
    const StudyTables& tables, std::size_t mark, std::size_t scene,
    const std::vector<std::string>& methods, const std::optional<PublishedStudy>& published);

/// Returns the explanation of these rows for a table's note, after a space; empty if there are
/// none.
std::string published_rows_explained(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published);

/// Returns the geometric mean over scenes of Table 2, "30.3 %", and the study's difference from it,
/// "+7.7 points"; dashes for a method or mark that Table 2 lacks. The study's baseline is OD.
std::vector<std::string> published_mean_and_difference(const MethodTimes& times,
                                                       const PublishedStudy& published);

}  // namespace foveola::analysis
