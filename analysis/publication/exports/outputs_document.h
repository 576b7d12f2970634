// The description of all files that an analysis writes.
#pragma once

#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// OUTPUTS.md: what all files have in common, what each of them is, and the columns of `tables`.
std::string outputs_in_words(const std::vector<Table>& tables);

}  // namespace foveola::analysis
