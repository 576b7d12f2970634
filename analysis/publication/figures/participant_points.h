// Draws every participant's points in a figure, joined from method to method.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"

namespace foveola::analysis {

/// Participants' points in the row of one method.
struct MethodPoints {
  std::size_t method = 0;  ///< Index in the set.
  std::vector<double> x;
  std::vector<double> y;
};

/// Points of the same participants in the same order with each method.
using JoinedPoints = std::vector<MethodPoints>;

/// Places points in lanes about the centre `y` of a row, which is `row_height` SVG units high, so
/// that they do not hide each other. `places`: positions of x along the axis, from 0 to 1.
MethodPoints points_in_row(std::size_t method, const std::vector<double>& x,
                           const std::vector<double>& places, double y, double row_height);

/// Returns the data blocks $participants_METHOD of all groups, and $joined, whose participants are
/// separated by blank lines.
std::string participant_data(const std::vector<JoinedPoints>& groups);

/// Plots these blocks of the methods from `first_method` on: hollow points above lines, which are
/// thinner the more there are.
std::vector<std::string> participant_layers(const StudyTables& tables, std::size_t first_method);

/// Returns the lane of each point: 0 at the centre of the row, then 1, -1, 2, -2 and so on up to
/// `lanes` lanes, an odd number. Points of a lane are at least `width` apart, and in the innermost
/// lane that allows it. If all lanes are taken, a point goes to the lane of least overlap. Equal
/// positions give equal lanes.
std::vector<int> point_lanes(const std::vector<double>& positions, double width, std::size_t lanes);

}  // namespace foveola::analysis
