// Measures the coverage of the intervals of R's models, over drawn studies.
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
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// Studies whose planned comparison's primary analysis is a model by R.
struct ModelCell {
  std::string name;
  ExpectedStudy expected;  ///< With one planned comparison.
  std::size_t participants = 16;
  double gaps = 0.0;  ///< Probability that a trial's values are missing.
  bool is_rating = false;
  std::uint64_t stream = 0;  ///< Separates the cells' random streams; below 256.
};

/// Returns nineteen cells: Tobit models of 16 and 37 participants in these scenes, 13, 32 and 50 %
/// of the baseline's times right-censored, and of 12 and 40 in random scenes; crossed models of 16
/// and 40 participants with gaps; cumulative link mixed models of 16 and 24 participants, and of 16
/// whose ratings the methods separate; tests of equivalence within 25 % of 24 participants, 0, 20
/// and 40 % of the baseline's times right-censored, of a ratio at the margin and of 1.
std::vector<ModelCell> model_cells();

struct ModelCoverageSettings {
  std::size_t studies = 500;  ///< Of each cell; of those with ordinal models two fifths,
                              ///< and of separated ratings a twentieth.
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one per core; the figures do not depend on it.
};

/// Returns the expected duration of `measure` in seconds, by timing this many studies in the
/// proportions of all.
double expected_seconds(const std::vector<ModelCell>& cells, const ModelCoverageSettings& settings,
                        const ModelFitter& fit);

/// Counts the studies of a cell in which the model's interval covers the planned ratio, or no
/// difference between ratings; the rest are type I errors. With a margin it counts the studies that
/// declare the methods equivalent; at the margin at most 6.8 % are allowed. With separated ratings
/// it counts the studies that find the difference: at least 99 % are required. With fixed scenes
/// the ratio is that in the study's scenes; the ratio in the population of scenes is reported, too,
/// as is the substitute without R. Otherwise 95 ± 1.5 % is required, as far as so few studies show.
/// Studies without a fit are left out; those without censored or missing values have their planned
/// analysis without R. Empty when `stop` was requested. Throws Error if R, or a package, is
/// missing.
std::vector<CoverageFigure> measure_model_coverage(const ModelCell& cell,
                                                   const ModelCoverageSettings& settings,
                                                   const ModelFitter& fit,
                                                   const std::stop_token& stop);

/// Fits the models of each study's planned comparisons by models.R, as analyze does, in a temporary
/// folder; results are in the order of the studies. R is started once for all of them. May be
/// called by several threads at once. A study without models says in `missing` why: R is missing or
/// failed, or no session is completed. A model without a fit says so in its note. Throws Error if
/// files cannot be written or read.
std::vector<FittedModels> fit_studies(const std::vector<study::StudyRecords>& studies);

}  // namespace foveola::analysis
