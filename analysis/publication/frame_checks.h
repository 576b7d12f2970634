// Data-quality checks of the frames that participants saw.
#pragma once

#include <vector>

#include "analysis/publication/data_quality_check.h"
#include "study/record/data_quality_records.h"

namespace foveola::analysis {

/// Of each participant's frames against a limit: those that missed their refresh, those without a
/// valid gaze, their latency, and how long before a mark they were shown.
std::vector<DataQualityCheck> check_frames(const std::vector<study::FrameFigures>& frames);

}  // namespace foveola::analysis
