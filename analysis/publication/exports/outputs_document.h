// Describes all files that an analysis writes.
#pragma once

#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Returns OUTPUTS.md: facts common to all files, a line per file, and the columns of `tables`.
std::string outputs_in_words(const std::vector<Table>& tables);

}  // namespace foveola::analysis
