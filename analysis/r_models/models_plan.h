// What models.R has to fit.
#pragma once

#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// models_plan.csv: a row for each of the pairs, with its measure's kind and whether scenes are
/// random.
Table models_plan(const Dataset& set, const std::vector<ComparedPair>& pairs,
                  study::SceneEffects scenes);

}  // namespace foveola::analysis
