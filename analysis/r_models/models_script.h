// The R script that fits a study's models: models.R as a string.
#pragma once

namespace foveola::analysis {

const char* models_script();

}  // namespace foveola::analysis
