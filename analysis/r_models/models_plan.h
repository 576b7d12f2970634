// What models.R has to fit.
#pragma once

#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// How much models.R computes of each model.
enum class ModelDetail {
  full,    ///< With profile intervals of ordinal models, and estimates without each participant.
  p_only,  ///< Without these, which take many more fits: for thousands of studies.
};

/// models_plan.csv: a row for each of the pairs, with its measure's kind and whether scenes are
/// random.
Table models_plan(const Dataset& set, const std::vector<ComparedPair>& pairs,
                  study::SceneEffects scenes, ModelDetail detail = ModelDetail::full);

}  // namespace foveola::analysis
