// What the figures of a study are drawn with: frame, typeface, rows, points and estimates.
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

/// The frame and the typeface that all figures share, and whose data they show.
std::string figure_preamble(const StudyTables& tables);

/// Names the rows of a figure by its methods; row 0 is at the top.
std::string row_names(const std::vector<std::string>& methods);

/// The ids of these marks, which are indices of the set's measures.
std::vector<std::string> ids_of(const StudyTables& tables, const std::vector<std::size_t>& marks);

/// A method has the same colour in every figure, and the same shape of points, so that methods
/// differ by more than their colours. `method` is its index in the set.
const FigureColor& method_color(std::size_t method);
int hollow_point(std::size_t method);

/// A line of a data block: x, the ends of its interval, y.
std::string estimate_line(const Estimate& estimate, double y);

/// Plots such a block: filled points on their intervals.
std::string estimates_layer(const std::string& block, std::size_t method);

/// The same with hollow points.
std::string hollow_estimates_layer(const std::string& block, std::size_t method);

/// An entry of the key for the method's estimates.
std::string method_key(const StudyTables& tables, std::size_t method);

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
