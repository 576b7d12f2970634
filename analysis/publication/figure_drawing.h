// What all figures are drawn with: their frame, typeface and rows.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/figures.h"

namespace foveola::analysis {

/// The frame and the typeface that all figures share, and whose data they show.
std::string figure_preamble(const StudyTables& tables);

/// Names the rows of a figure by its methods; row 0 is at the top.
std::string row_names(const std::vector<std::string>& methods);

/// Draws `script`, which sets no terminal. Throws Error if gnuplot is missing.
Figure drawn_figure(const std::string& name, int width, int height, const std::string& script);

}  // namespace foveola::analysis
