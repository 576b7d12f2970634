// Draws the figure of a rating.
#pragma once

#include <cstddef>
#include <optional>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// Draws the shares of the answers if the rating has few points, else each participant's mean and
/// the means over participants with 95 % confidence intervals. `rating`: index of the set's
/// measures. Empty without values.
std::optional<Figure> rating_figure(const StudyTables& tables, std::size_t rating);

}  // namespace foveola::analysis
