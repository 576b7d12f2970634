// The methods paragraph of a paper, written from the protocol and what was analysed.
#pragma once

#include <string>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"

namespace foveola::analysis {

/// Plain sentences, ready to be edited: who took part, what they saw in which order, what they
/// marked and rated, on which display, and how it was analysed. What the protocol does not say is
/// left out; data that are not people's are called so.
std::string methods_paragraph(const StudyTables& tables, const Comparisons& comparisons,
                              const study::StudyRecords& records);

}  // namespace foveola::analysis
