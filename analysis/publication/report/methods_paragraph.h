// Writes a paper's methods paragraph from the protocol and the analysed data.
#pragma once

#include <string>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "study/record/read/data_quality_records.h"

namespace foveola::analysis {

/// Returns plain sentences, ready to be edited. They cover participants, stimuli and orders, marks
/// and ratings, display, gaze source, equipment, programs and analysis, and differences between
/// sessions. Facts that neither protocol nor record has are left out. Data that are not people's
/// are called so.
std::string methods_paragraph(const StudyTables& tables, const Comparisons& comparisons,
                              const study::StudyRecords& records,
                              const study::DataQualityRecords& quality);

}  // namespace foveola::analysis
