// Spearman's rank correlation, beside Pearson's in inference.h.
#pragma once

#include <optional>
#include <span>

#include "analysis/statistics/inference.h"

namespace foveola::analysis {

/// Pearson's correlation of the ranks, ties sharing theirs. t and its P-value are the approximation
/// by Student's t with n - 2 degrees of freedom (as R's cor.test with exact = FALSE); the interval
/// is Fisher's z with the variance (1 + r^2 / 2) / (n - 3) of Bonett and Wright (2000). All values
/// finite. Empty as pearson.
std::optional<Correlation> spearman(std::span<const double> x, std::span<const double> y,
                                    double confidence = default_confidence);

}  // namespace foveola::analysis
