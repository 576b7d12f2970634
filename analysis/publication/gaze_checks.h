// Data-quality checks of gaze and objects.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/data_quality_check.h"
#include "analysis/publication/gaze_by_trial.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Of the analysed participants: their last validations, marks with the object out of view, and
/// trials with the gaze elsewhere.
std::vector<DataQualityCheck> check_gaze(const Dataset& set, const study::StudyRecords& records,
                                         const std::vector<study::GazeRunRow>& runs,
                                         const GazeOfTrials& gaze);

}  // namespace foveola::analysis
