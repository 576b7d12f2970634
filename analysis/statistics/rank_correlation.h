// Spearman's rank correlation; Pearson's is in inference.h.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/statistics/inference.h"

namespace foveola::analysis {

/// Up to this many pairs the P-value is exact, whether or not there are ties: twice the share of
/// all orders of y whose correlation is at least as far on the same side (as R's cor.test, which
/// refuses ties).
inline constexpr std::size_t largest_exact_spearman = 9;

/// Pearson's correlation of the ranks, ties sharing theirs. Above `largest_exact` pairs the P-value
/// is the approximation by Student's t with n - 2 degrees of freedom (as R's cor.test with
/// exact = FALSE). The interval is Fisher's z with the variance (1 + r^2 / 2) / (n - 3) of Bonett
/// and Wright (2000). All values are finite. Empty where pearson is.
std::optional<Correlation> spearman(std::span<const double> x, std::span<const double> y,
                                    double confidence = default_confidence,
                                    std::size_t largest_exact = largest_exact_spearman);

}  // namespace foveola::analysis
