// Fits models to a study by R: runs the script, and reads its results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/dataset/fitted_model.h"

namespace foveola::analysis {

/// Debian packages that provide R and the packages of models.R.
inline constexpr const char* r_packages =
    "r-base-core r-cran-lme4 r-cran-lmertest r-cran-survival r-cran-ordinal";

/// Runs models.R, the script, once for all folders. Each has the trials_long.csv and
/// models_plan.csv of a study, and gets r_models.csv and r_versions.csv, which are read. If R is
/// missing or fails, every result says so in `missing`, and has no models. Throws Error if the
/// script's results cannot be read.
std::vector<FittedModels> fit_models(const std::filesystem::path& script,
                                     const std::vector<std::filesystem::path>& folders);

/// As above, for one folder, which contains models.R.
FittedModels fit_models(const std::filesystem::path& folder);

/// Returns why models could not be fitted here: R did not run, or lacks packages. Empty if nothing
/// is missing. A model that needs a missing package has no fit, which says nothing about the study.
std::string missing_for(const FittedModels& models);

/// Reads the two tables that models.R writes. Throws Error for anything else.
FittedModels read_models(const std::string& models_csv, const std::string& versions_csv);

}  // namespace foveola::analysis
