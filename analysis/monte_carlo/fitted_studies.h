// Models that R fits to studies that were drawn.
#pragma once

#include <vector>

#include "analysis/dataset/fitted_model.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Fits the models of each study's planned comparisons by models.R, as analyze does, in a temporary
/// folder; the results are in the order of the studies. R is started once for all of them. May be
/// called by several threads at once. A study without models says in `missing` why: R is not there
/// or ended in an error, or no session is completed; a model that R could not fit says so in its
/// note. Throws Error if files cannot be written or read.
std::vector<FittedModels> fit_studies(const std::vector<study::StudyRecords>& studies);

}  // namespace foveola::analysis
