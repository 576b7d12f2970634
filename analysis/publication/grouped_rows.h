// The rows of a figure in groups under headings, as a forest plot has them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/publication/figure_palette.h"

namespace foveola::analysis {

/// Groups one under the other, each with the same rows below its heading; y counts downwards from
/// 0, in rows.
struct GroupedRows {
  std::vector<std::string> headings;
  std::vector<std::string> rows;
  double heading_height = 0.5;  ///< In rows.

  double group_height() const { return heading_height + static_cast<double>(rows.size()); }
  double height() const { return group_height() * static_cast<double>(headings.size()); }
  /// The middle of a row.
  double y(std::size_t group, std::size_t row) const {
    return group_height() * static_cast<double>(group) + heading_height + static_cast<double>(row) +
           0.5;
  }
};

/// A line across the plot.
std::string horizontal_rule(double y, const FigureColor& color);

/// gnuplot's y axis: the rows' names beside it, the headings in the plot, lines between groups.
std::string row_axis(const GroupedRows& rows);

}  // namespace foveola::analysis
