// From a study's file to a folder of tables, figures and a report.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/comparisons.h"
#include "analysis/publication/data_quality_checks.h"
#include "analysis/publication/study_tables.h"
#include "study/record/maintenance.h"
#include "study/record/recorded_gaze.h"

namespace foveola::analysis {

struct AnalysisOptions {
  bool bids = false;        ///< also bids/, with a folder for each participant
  bool unverified = false;  ///< analyse a study's file even if it is not what was written
};

/// Calls its argument for every attempt's gaze, as study::visit_gaze does; empty: there is none.
using GazeReader = std::function<void(const std::function<void(const study::AttemptGaze&)>&)>;

struct AnalysisOutput {
  std::filesystem::path report;              ///< report.html
  std::vector<std::filesystem::path> files;  ///< everything that was written
  std::string summary;  ///< a table for the terminal, several lines, ready to print
  std::vector<std::string> warnings;
  StudyTables tables;
  Comparisons comparisons;
  DataQualityReport checks;
  std::optional<study::Verification> record;  ///< of the study's file, if one was read
};

/// Verifies the study's file, reads it and writes the published tables and figures to `folder`,
/// which is made if its parent exists. Files of an earlier analysis are replaced, others left
/// alone; nothing is written before everything is computed. Throws Error if the file is not what
/// was written (unless options.unverified), there is nothing to analyse, or the folder cannot be
/// written.
AnalysisOutput analyze_study(const std::filesystem::path& database,
                             const std::filesystem::path& folder,
                             const AnalysisOptions& options = {});

/// The same for records at hand; `record` is what verifying their file found, if they are of one.
AnalysisOutput analyze_records(study::StudyRecords records,
                               const study::DataQualityRecords& quality,
                               const std::filesystem::path& folder,
                               const AnalysisOptions& options = {},
                               const GazeReader& read_gaze = {},
                               std::optional<study::Verification> record = {});

}  // namespace foveola::analysis
