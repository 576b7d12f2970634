// Models that R fits to a study: running the script, and reading what it wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/dataset/fitted_model.h"

namespace foveola::analysis {

/// The packages of Debian that provide R and everything that models.R uses.
inline constexpr const char* r_packages =
    "r-base-core r-cran-lme4 r-cran-lmertest r-cran-survival r-cran-ordinal";

/// Runs models.R, the script, once for all folders, each of which has the trials_long.csv and
/// models_plan.csv of a study, and reads the r_models.csv and r_versions.csv that it writes there.
/// If R is not there or ends in an error, every result says so in `missing`, and has no models.
/// Throws Error if what the script wrote cannot be read.
std::vector<FittedModels> fit_models(const std::filesystem::path& script,
                                     const std::vector<std::filesystem::path>& folders);

/// The same of one folder, which has models.R, too.
FittedModels fit_models(const std::filesystem::path& folder);

/// Why not everything that models.R can fit was fitted here: R did not run, or the packages that it
/// does not have. Empty if all is there. A model that needs what is missing has no fit, which says
/// nothing of the study.
std::string missing_for(const FittedModels& models);

/// Reads the two tables that models.R writes. Throws Error for anything else.
FittedModels read_models(const std::string& models_csv, const std::string& versions_csv);

}  // namespace foveola::analysis
