// The published figures as SVG, PDF and PNG, drawn by gnuplot.
#pragma once

#include <string>
#include <vector>

#include "analysis/publication/study_tables.h"

namespace foveola::analysis {

/// Above so many participants the figures of times leave out the dots of single ones.
inline constexpr std::size_t most_dots = 500;

struct Figure {
  std::string name;  ///< a file name without its extension
  std::string svg;   ///< a file of its own, on white
  std::string pdf;   ///< the same for print
  std::string png;   ///< the same for slides, of twice the size
};

/// Fig. 5, relative and in seconds, and Fig. 6, as far as there are values. Throws Error if gnuplot
/// is missing.
std::vector<Figure> draw_figures(const StudyTables& tables);

}  // namespace foveola::analysis
