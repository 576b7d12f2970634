// Parts of gnuplot scripts that the study's figures share: frame, typeface, rows, points,
// estimates.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/gnuplot/gnuplot.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

// In SVG units.
inline constexpr int figure_width = 640;
inline constexpr int lower_axis_height = 70;
inline constexpr int upper_axis_height = 46;

/// Returns the frame and the typeface of all figures, with the notice whose data they show.
std::string figure_preamble(const StudyTables& tables);

/// Labels the rows of a figure with its methods; row 0 is at the top.
std::string row_names(const std::vector<std::string>& methods);

/// Returns the ids of these marks, given as indices of the set's measures.
std::vector<std::string> ids_of(const StudyTables& tables, const std::vector<std::size_t>& marks);

/// Returns a method's colour, the same in every figure, as is its point shape: methods differ by
/// more than colour. `method`: index in the set.
const FigureColor& method_color(std::size_t method);
int hollow_point(std::size_t method);

/// Returns a line of a data block: x, the ends of its interval, y.
std::string estimate_line(const Estimate& estimate, double y);

/// Plots such a block as filled points on their intervals.
std::string estimates_layer(const std::string& block, std::size_t method);

/// Plots such a block as hollow points on their intervals.
std::string hollow_estimates_layer(const std::string& block, std::size_t method);

/// Returns a key entry for the method's estimates.
std::string method_key(const StudyTables& tables, std::size_t method);

/// Layout of groups below one another, each with the same rows below its heading. y counts rows
/// downwards from 0.
struct GroupedRows {
  std::vector<std::string> headings;
  std::vector<std::string> rows;
  double heading_height = 0.5;  ///< In rows.

  double group_height() const { return heading_height + static_cast<double>(rows.size()); }
  double height() const { return group_height() * static_cast<double>(headings.size()); }
  /// Returns the centre of a row.
  double y(std::size_t group, std::size_t row) const {
    return group_height() * static_cast<double>(group) + heading_height + static_cast<double>(row) +
           0.5;
  }
};

std::string horizontal_rule(double y, const FigureColor& color);

/// Returns gnuplot's y axis: the rows' names beside it, the headings in the plot, lines between
/// groups.
std::string row_axis(const GroupedRows& rows);

}  // namespace foveola::analysis
