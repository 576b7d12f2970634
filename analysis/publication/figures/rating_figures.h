// The figure of a rating.
#pragma once

#include <cstddef>
#include <optional>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// The shares of the answers of a rating whose points are counted, or each participant's mean with
/// the means over participants and their 95 % intervals. `rating` is its index in the set's
/// measures. Empty without values.
std::optional<Figure> rating_figure(const StudyTables& tables, std::size_t rating);

}  // namespace foveola::analysis
