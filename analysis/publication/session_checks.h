// Data-quality checks of how sessions went.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/data_quality_check.h"
#include "study/record/data_quality_records.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Of the analysed participants: sessions that were cut off and went on, trials that were timed
/// again for another reason, notes that somebody should read, the programs that ran the sessions,
/// and what these ran on.
std::vector<DataQualityCheck> check_sessions(const Dataset& set, const study::StudyRecords& records,
                                             const study::DataQualityRecords& quality);

}  // namespace foveola::analysis
