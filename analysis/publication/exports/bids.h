// Writes the behavioural data in the Brain Imaging Data Structure (BIDS 1.11.1).
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/exports/data_files.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// Returns the participants' unique labels in BIDS, in the order of tables.set.participants: the
/// letters and digits of the code, with a number appended where codes share them in any case.
std::vector<std::string> bids_labels(const Dataset& set);

/// Returns bids/README, dataset_description.json, participants.tsv with its sidecar,
/// task-preview_beh.json, and sub-LABEL/beh/sub-LABEL_task-preview_beh.tsv for each analysed
/// participant. Rows are trials in the planned order. LABEL is from bids_labels; participants.tsv
/// has the codes. Missing values are "n/a".
std::vector<TextFile> bids_files(const StudyTables& tables, const study::StudyRecords& records,
                                 const ColumnsOf<std::size_t>& trials,
                                 const ColumnsOf<std::size_t>& answers);

}  // namespace foveola::analysis
