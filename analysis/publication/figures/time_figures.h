// The figures of the times of all marks: each mark a group of rows, or a figure of curves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// The marks with values over all scenes, which these figures draw: somebody has a scene in which
/// every method was measured.
std::vector<std::size_t> marks_over_all_scenes(const StudyTables& tables);

/// relative_times: every participant in per cent of the baseline, on a logarithmic axis, and the
/// geometric means over participants with their 95 % intervals. Empty without values.
std::optional<Figure> relative_figure(const StudyTables& tables);

/// times_in_seconds: as relative_times, in seconds, with the baseline. Empty without values.
std::optional<Figure> seconds_figure(const StudyTables& tables);

/// time_to_MARK: the share of trials without the mark by time, a Kaplan-Meier curve for each
/// method; `mark` is an index of the set's measures. Empty without times. Throws Error if gnuplot
/// is missing.
std::optional<Figure> survival_figure(const StudyTables& tables, std::size_t mark);

/// The name of that figure.
std::string survival_figure_name(const Measure& mark);

}  // namespace foveola::analysis
