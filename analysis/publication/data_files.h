// The data as files for other programs: tables of everything recorded, a folder as Psych-DS lays it
// out, and scripts for R.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/trial_data.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// A folder as Psych-DS 1 describes it: its description, and the names of its data files, which
/// hold the trials that count and the participants.
struct PsychDs {
  TextFile description;
  std::string trials_name;
  std::string participants_name;
};
PsychDs psych_ds(const StudyTables& tables, const TrialColumns& trials,
                 const ParticipantColumns& participants);

/// R scripts for what Foveola leaves to R: mixed models of log times with missing cells (lme4,
/// emmeans), and ordinal models of ratings (ordinal). They read trials_long.csv beside them.
std::vector<TextFile> r_scripts(const Dataset& set);

}  // namespace foveola::analysis
