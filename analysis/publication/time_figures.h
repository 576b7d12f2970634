// Draws the figures of the times of all marks, each mark a group of rows.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/publication/figures.h"

namespace foveola::analysis {

/// Returns the marks of these figures: those for which a participant has a scene in which every
/// method was measured.
std::vector<std::size_t> marks_over_all_scenes(const StudyTables& tables);

/// relative_times: every participant in per cent of the baseline, on a logarithmic axis, and the
/// geometric means over participants with 95 % confidence intervals. Empty without values.
std::optional<Figure> relative_figure(const StudyTables& tables);

/// times_in_seconds: as relative_times, in seconds, with the baseline. Empty without values.
std::optional<Figure> seconds_figure(const StudyTables& tables);

}  // namespace foveola::analysis
