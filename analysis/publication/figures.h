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
  // What pdf_of and png_of draw it from again.
  int width = 0;       ///< SVG units, 1/96 inch
  int height = 0;      ///< likewise
  std::string script;  ///< gnuplot's, without its terminal
};

/// Fig. 5, relative and in seconds, and Fig. 6, as far as there are values. Throws Error if gnuplot
/// is missing.
std::vector<Figure> draw_figures(const StudyTables& tables);

/// The same figure for print, without a date: same figure, same bytes. Throws Error likewise.
std::string pdf_of(const Figure& figure);

/// The same figure for slides, of twice the size. Throws Error likewise.
std::string png_of(const Figure& figure);

}  // namespace foveola::analysis
