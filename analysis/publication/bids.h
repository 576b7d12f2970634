// The behavioural data as the Brain Imaging Data Structure (BIDS 1.8) lays them out.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/study_tables.h"
#include "analysis/publication/table_files.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// bids/dataset_description.json, participants.tsv with its sidecar, task-preview_beh.json, and
/// sub-LABEL/beh/sub-LABEL_task-preview_beh.tsv for each analysed participant, whose rows are
/// trials in the order in which they were planned. LABEL has the letters and digits of the
/// participant's code, and a number behind them where two codes have the same; participants.tsv
/// has the codes. Missing values are "n/a".
std::vector<TextFile> bids_files(const StudyTables& tables,
                                 const std::vector<study::BackgroundRow>& answers);

}  // namespace foveola::analysis
