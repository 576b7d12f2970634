// The figures as SVG, PDF and PNG, drawn by gnuplot.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/gnuplot/gnuplot.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// Above this many participants the figures leave out the dots of single participants.
inline constexpr std::size_t max_dots = 500;

/// The name of the figure of a rating.
std::string rating_figure_name(const Measure& rating);

/// Whether every participant's point is drawn.
bool draws_participants(const StudyTables& tables);

/// Draws the times of all marks, relative_times, relative_times_by_scene and times_in_seconds, the
/// curve time_to_MARK of each mark, and each rating in numbers, as far as there are values; several
/// at a time. Without a font, only as SVG. Throws Error if gnuplot is missing.
std::vector<Figure> draw_figures(const StudyTables& tables);

/// Each figure as NAME.svg, and NAME.pdf and NAME.png if it has them.
std::vector<TextFile> files_of_figures(const std::vector<Figure>& figures);

}  // namespace foveola::analysis
