// Checks the quality of sessions, frames, gaze and objects.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// Checks the analysed participants' sessions: interruptions that were resumed, trials retimed for
/// another reason, unusual notes, the sessions' programs and their equipment.
std::vector<DataQualityCheck> check_sessions(const Dataset& set, const study::StudyRecords& records,
                                             const study::DataQualityRecords& quality);

/// Checks each participant's frames against limits: missed refreshes, frames without a valid gaze,
/// latency, and the time from a frame to the mark upon it.
std::vector<DataQualityCheck> check_frames(const std::vector<study::FrameFigures>& frames);

/// Checks the analysed participants' last validations, marks with the object out of view, and
/// trials with the gaze elsewhere.
std::vector<DataQualityCheck> check_gaze(const Dataset& set, const study::StudyRecords& records,
                                         const std::vector<study::GazeRunRow>& runs,
                                         const GazeOfTrials& gaze);

}  // namespace foveola::analysis
