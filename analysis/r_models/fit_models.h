// Models that R fits to a study: running the script, and reading what it wrote.
#pragma once

#include <filesystem>
#include <string>

#include "analysis/dataset/fitted_model.h"

namespace foveola::analysis {

/// The packages of Debian that provide R and everything that models.R uses.
inline constexpr const char* r_packages =
    "r-base-core r-cran-lme4 r-cran-lmertest r-cran-survival r-cran-ordinal";

/// Runs models.R in a folder that has it, trials_long.csv and models_plan.csv, and reads the
/// r_models.csv and r_versions.csv that it writes there. If R is not there or ends in an error,
/// the result says so in `missing`, and has no models. Throws Error if what the script wrote cannot
/// be read.
FittedModels fit_models(const std::filesystem::path& folder);

/// Reads the two tables that models.R writes. Throws Error for anything else.
FittedModels read_models(const std::string& models_csv, const std::string& versions_csv);

}  // namespace foveola::analysis
