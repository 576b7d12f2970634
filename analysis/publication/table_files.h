// The study's tables as CSV files with fixed column names, units in the names.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/study_tables.h"

namespace foveola::analysis {

struct TextFile {
  std::string name;
  std::string content;
};

/// table1_background.csv, table2_times.csv, figure5_geometric_means.csv,
/// figure6_artifact_ratings.csv, background_correlation.csv, exclusions.csv and
/// amended_sessions.csv. A value that does not exist is an empty field; the last column of each
/// table says who took part: human, pilot or simulated.
std::vector<TextFile> table_files(const StudyTables& tables);

}  // namespace foveola::analysis
