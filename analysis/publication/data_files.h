// The data as files for other programs: a folder as Psych-DS lays it out.
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

}  // namespace foveola::analysis
