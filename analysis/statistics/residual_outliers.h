// Single trials that stand out from what their participant and condition let one expect.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/statistics/additive_fit.h"

namespace foveola::analysis {

struct ResidualOutlier {
  std::size_t index = 0;     ///< Index of the trial in the values given.
  double deviation = 0.0;    ///< From the fit to the trials that are no outliers, in values' unit.
  double studentized = 0.0;  ///< Its studentized residual when it was taken out.
};

/// At most so many outliers are found.
inline constexpr std::size_t most_residual_outliers = 20;

/// The trials that do not belong to an additive model of participants and conditions with normal
/// residuals, the farthest first, by the generalized extreme studentized residual (Paul and Fung
/// 1991, Technometrics 33; Rosner's 1983 method in a linear model): the trial with the largest
/// studentized residual is taken out and the model fitted anew, `most_residual_outliers` times or
/// up to a fifth of the residual degrees of freedom; the outliers are those up to the last that
/// exceeded its limit, the Bonferroni bound of the largest at level alpha. So some outliers do not
/// mask each other, and of studies with normal residuals a share of about alpha has any. Cells may
/// be missing or repeated; leverages are those of a complete design, 1 / n_participant + 1 /
/// n_condition - 1 / n. Empty where the values do not vary beyond the model.
std::vector<ResidualOutlier> residual_outliers(const std::vector<TrialValue>& values,
                                               double alpha = 0.05);

}  // namespace foveola::analysis
