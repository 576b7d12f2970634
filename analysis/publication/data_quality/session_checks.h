// Data-quality checks of how sessions went, of frames, and of gaze and objects.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Of the analysed participants: sessions that were cut off and went on, trials that were timed
/// again for another reason, notes that somebody should read, the programs that ran the sessions,
/// and what these ran on.
std::vector<DataQualityCheck> check_sessions(const Dataset& set, const study::StudyRecords& records,
                                             const study::DataQualityRecords& quality);

/// Of each participant's frames against a limit: those that missed their refresh, those without a
/// valid gaze, their latency, and how long before a mark they were shown.
std::vector<DataQualityCheck> check_frames(const std::vector<study::FrameFigures>& frames);

/// Of the analysed participants: their last validations, marks with the object out of view, and
/// trials with the gaze elsewhere.
std::vector<DataQualityCheck> check_gaze(const Dataset& set, const study::StudyRecords& records,
                                         const std::vector<study::GazeRunRow>& runs,
                                         const GazeOfTrials& gaze);

}  // namespace foveola::analysis
