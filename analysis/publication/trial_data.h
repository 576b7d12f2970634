// The data for other programs: a row per trial, a row per participant, what each column means, and
// scripts that read them.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/analysis_set.h"
#include "analysis/publication/study_tables.h"
#include "analysis/publication/table_files.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// A column of the data files.
struct Variable {
  std::string name;
  std::string unit;  ///< "s", "points", or empty.
  std::string type;  ///< "string", "integer", "number" or "boolean".
  std::string description;
};

/// The columns of the long table, in their order; `scale` describes the rating's column.
std::vector<Variable> trial_variables(const RatingScale& scale);

/// One row of the long table; what is missing is empty.
std::vector<std::string> trial_row(const AnalysisSet& set, std::size_t participant,
                                   std::size_t scene, std::size_t method);

/// One row per participant, scene and method of the analysed participants; what is missing is
/// empty.
std::string trials_long_csv(const AnalysisSet& set);

/// The columns of the wide table, in their order: those of the participant, MEASURE.SCENE.METHOD,
/// and background.QUESTION.
std::vector<Variable> participant_variables(const AnalysisSet& set,
                                            const std::vector<study::BackgroundRow>& answers);

/// One row per participant: their values in each scene with each method, then their answers about
/// their background.
std::string participants_wide_csv(const AnalysisSet& set,
                                  const std::vector<study::BackgroundRow>& answers);

/// A description of each column of the long table.
std::string codebook_csv(const RatingScale& scale);

/// A folder as Psych-DS 1 describes it: its description, and the names of its data files, which
/// hold the long and the wide table.
struct PsychDs {
  TextFile description;
  std::string trials_name;
  std::string participants_name;
};
PsychDs psych_ds(const StudyTables& tables, const std::vector<study::BackgroundRow>& answers);

/// R scripts for what Foveola leaves to R: mixed models of log times with missing cells (lme4,
/// emmeans), and ordinal models of ratings (ordinal). They read the long table beside them.
std::vector<TextFile> r_scripts();

}  // namespace foveola::analysis
