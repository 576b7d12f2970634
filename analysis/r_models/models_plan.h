// Writes the plan of models for models.R.
#pragma once

#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Amount of results per model.
enum class ModelDetail {
  full,    ///< With profile intervals of ordinal models, and estimates without each participant.
  p_only,  ///< Without these, which take many more fits: for thousands of studies.
};

/// models_plan.csv: a row per pair, with its measure's kind and whether scenes are random.
Table models_plan(const Dataset& set, const std::vector<ComparedPair>& pairs,
                  study::SceneEffects scenes, ModelDetail detail = ModelDetail::full);

}  // namespace foveola::analysis
