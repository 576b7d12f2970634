// Draws the figures of the times of all marks: each mark a group of rows, or curves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// Returns the marks of these figures: those for which a participant has a scene in which every
/// method was measured.
std::vector<std::size_t> marks_over_all_scenes(const StudyTables& tables);

/// relative_times: every participant in per cent of the baseline, on a logarithmic axis, and the
/// geometric means over participants with 95 % confidence intervals. Empty without values.
std::optional<Figure> relative_figure(const StudyTables& tables);

/// times_in_seconds: as relative_times, in seconds, with the baseline. Empty without values.
std::optional<Figure> seconds_figure(const StudyTables& tables);

/// time_to_MARK: Kaplan-Meier curves, the share of trials without the mark by time for each method.
/// `mark`: index of the set's measures. Empty without times. Throws Error if gnuplot is missing.
std::optional<Figure> survival_figure(const StudyTables& tables, std::size_t mark);

/// Returns the file name of that figure, without extension.
std::string survival_figure_name(const Measure& mark);

}  // namespace foveola::analysis
