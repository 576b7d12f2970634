// Draws the figures as SVG, PDF and PNG, by gnuplot.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/gnuplot/gnuplot.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// Maximum number of participants whose single points the figures draw.
inline constexpr std::size_t max_dots = 500;

/// Returns the file name of a rating's figure, without extension.
std::string rating_figure_name(const Measure& rating);

/// Returns whether every participant's point is drawn.
bool draws_participants(const StudyTables& tables);

/// Draws, several at a time, those figures that have values: relative_times,
/// relative_times_by_scene and times_in_seconds of all marks, time_to_MARK of each mark, and one
/// per numeric rating. Without a font, only as SVG. Throws Error if gnuplot is missing.
std::vector<Figure> draw_figures(const StudyTables& tables);

/// Returns each figure as NAME.svg, and NAME.pdf and NAME.png if it has them.
std::vector<TextFile> files_of_figures(const std::vector<Figure>& figures);

}  // namespace foveola::analysis
