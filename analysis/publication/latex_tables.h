// Tables for a paper: LaTeX with booktabs, their numbers as in the report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/publication/comparisons.h"
#include "analysis/publication/study_tables.h"
#include "analysis/publication/table_files.h"

namespace foveola::analysis {

/// `text` with LaTeX's special characters escaped.
std::string escape_latex(std::string_view text);

/// table2_times.tex, figure5_geometric_means.tex, figure6_artifact_ratings.tex and comparisons.tex:
/// a table environment each, whose caption says when the data are not people's.
std::vector<TextFile> latex_tables(const StudyTables& tables, const Comparisons& comparisons);

}  // namespace foveola::analysis
