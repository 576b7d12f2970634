// Analyses a study's file: verifies, reads, computes, and writes a folder of results.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "analysis/tables/table.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

struct AnalysisOptions {
  bool writes_bids = false;  ///< Also write bids/, with a folder for each participant.
  bool fits_models = false;  ///< Fit models by R, and take the primary analyses from them.
  bool unverified = false;   ///< Analyse a study's file even if its verification fails.
  /// Also write the data of withdrawn sessions to trials_long.csv, trials_timed_again.csv and
  /// answers_long.csv. The results do not use them.
  bool withdrawn = false;
};

/// Calls its argument for every attempt's gaze, as study::visit_gaze does. Empty: a study without
/// gaze.
using GazeReader = std::function<void(const std::function<void(const study::AttemptGaze&)>&)>;

struct AnalysisOutput {
  std::filesystem::path report;              ///< report.html
  std::vector<std::filesystem::path> files;  ///< All files that were written.
  std::string summary;                       ///< Lines for the terminal, ready to print.
  std::vector<std::string> warnings;
  StudyTables tables;
  Background background;
  Comparisons comparisons;
  DataQualityReport checks;
  /// Every table that was written. Tables that are written row by row have no rows here: trials,
  /// their gaze, answers and participants.
  std::vector<Table> results;
  std::optional<study::Verification> record;  ///< The verification of the study's file, if read.
};

/// Returns the findings of `foveola study verify`. Throws Error if the file is not a study, or was
/// changed and accept_changed is false.
study::Verification verified_study(const std::filesystem::path& database, bool accept_changed);

/// Returns whether a table is written row by row, because it may be too large for memory.
bool is_written_by_rows(const Table& table);

/// Verifies the study's file, reads it and writes its tables and figures to `folder`, which is made
/// if its parent exists. Files of an earlier analysis are replaced, or removed if this one does not
/// write them; other files, and those changed since, are left alone. Nothing is written before
/// everything is computed. Throws Error if the verification fails (unless options.unverified),
/// there is nothing to analyse, or the folder cannot be written.
AnalysisOutput analyze_study(const std::filesystem::path& database,
                             const std::filesystem::path& folder,
                             const AnalysisOptions& options = {});

/// Analyses records in memory. record: the verification of their file, if there is one. exported:
/// the same study with the data of its withdrawn sessions, for trials_long.csv,
/// trials_timed_again.csv, answers_long.csv and bids/; default: `records`. Throws Error as
/// analyze_study, except for a verification.
AnalysisOutput analyze_records(const study::StudyRecords& records,
                               const study::DataQualityRecords& quality,
                               const std::filesystem::path& folder,
                               const AnalysisOptions& options = {},
                               const GazeReader& read_gaze = {},
                               std::optional<study::Verification> record = {},
                               const std::optional<study::StudyRecords>& exported = {});

/// Returns the warnings to print first: about the file, the data and the planned comparisons, one
/// sentence each. `output` has its tables, comparisons, checks and verification.
std::vector<std::string> warnings_about(const AnalysisOutput& output);

}  // namespace foveola::analysis
