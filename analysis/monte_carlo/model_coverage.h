// How often the intervals of the models that R fits are right, over studies that are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/dataset/fitted_model.h"
#include "analysis/monte_carlo/coverage.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/monte_carlo/study_power.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Studies in which the planned comparison's primary analysis is a model by R.
struct ModelCell {
  std::string name;
  ExpectedStudy expected;  ///< With one planned comparison.
  std::size_t participants = 16;
  double gaps = 0.0;  ///< The probability that a trial's values are missing.
  bool is_rating = false;
  std::uint64_t stream = 0;  ///< Tells cells' random numbers apart; below 256.
};

/// Nineteen: Tobit models of 16 and 37 participants in these scenes, 13, 32 and 50 % of the
/// baseline's times right-censored, and of 12 and 40 in scenes like these; crossed models of 16 and
/// 40 participants with gaps; cumulative link mixed models of 16 and 24 participants, and of 16
/// whose ratings the methods separate; tests of equivalence within 25 % of 24 participants, 0, 20
/// and 40 % of the baseline's times right-censored, of a ratio at the margin and of 1.
std::vector<ModelCell> model_cells();

struct ModelCoverageSettings {
  std::size_t studies = 500;  ///< Of each cell; of those with ordinal models two fifths,
                              ///< and of separated ratings a twentieth.
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0 takes every core; the figures do not depend on it.
};

/// How long `measure` will take with these settings, in seconds, by timing so many studies in the
/// proportions of all.
double expected_seconds(const std::vector<ModelCell>& cells, const ModelCoverageSettings& settings,
                        const ModelFitter& fit);

/// In how many studies of a cell the interval of the model covers the planned ratio, or no
/// difference between ratings; what is not covered is the test's error of the first kind. With a
/// margin it is instead in how many the methods are declared equivalent; at the margin at most 6.8
/// % are required. Of separated ratings it is in how many the difference is found: 99 % at least.
/// With fixed scenes it is the ratio in the scenes of the study, and the one in all scenes like
/// these is reported, too; so is what stands in without R. Required is 95 ± 1.5 %, as far as so few
/// studies show. Studies that the model could not be fitted to are not among them; those in which
/// nothing is censored, or missing, have what is planned for them without R. Empty when `stop` was
/// requested. Throws Error if R, or a package, is missing.
std::vector<CoverageFigure> measure_model_coverage(const ModelCell& cell,
                                                   const ModelCoverageSettings& settings,
                                                   const ModelFitter& fit,
                                                   const std::stop_token& stop);

/// Fits the models of each study's planned comparisons by models.R, as analyze does, in a temporary
/// folder; the results are in the order of the studies. R is started once for all of them. May be
/// called by several threads at once. A study without models says in `missing` why: R is not there
/// or ended in an error, or no session is completed; a model that R could not fit says so in its
/// note. Throws Error if files cannot be written or read.
std::vector<FittedModels> fit_studies(const std::vector<study::StudyRecords>& studies);

}  // namespace foveola::analysis
