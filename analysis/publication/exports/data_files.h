// Writes the data as files for other programs: a Psych-DS folder, and gzip (RFC 1952).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/tables/table.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// A folder of Psych-DS 1: its description, and the names of its data files, which hold the
/// counting trials and the participants.
struct PsychDs {
  TextFile description;
  std::string trials_name;
  std::string participants_name;
};
PsychDs psych_ds(const StudyTables& tables, const std::vector<Column>& trials,
                 const std::vector<Column>& participants);

/// Returns `text` as a gzip file. Throws std::length_error from almost 4 GiB on. Equal texts give
/// equal bytes: the header has no name and no time.
std::string gzip(std::string_view text);

}  // namespace foveola::analysis
