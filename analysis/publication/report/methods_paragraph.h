// The methods paragraph of a paper, written from the protocol and what was analysed.
#pragma once

#include <string>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "study/record/data_quality_records.h"

namespace foveola::analysis {

/// Plain sentences, ready to be edited: who took part, what they saw in which order, what they
/// marked and rated, on which display, where the gaze came from, on what and by which program, and
/// how it was analysed; where sessions differ, that they do. What neither protocol nor record says
/// is left out; data that are not people's are called so.
std::string methods_paragraph(const StudyTables& tables, const Comparisons& comparisons,
                              const study::StudyRecords& records,
                              const study::DataQualityRecords& quality);

}  // namespace foveola::analysis
