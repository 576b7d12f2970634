// Every participant's point in a figure, joined from method to method.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"

namespace foveola::analysis {

/// Participants' points in the row of one method.
struct MethodPoints {
  std::size_t method = 0;  ///< Its index in the set.
  std::vector<double> x;
  std::vector<double> y;
};

/// Points of the same participants in the same order with each method.
using JoinedPoints = std::vector<MethodPoints>;

/// Points whose lanes about the middle `y` of a row, which is `row_height` SVG units high, keep
/// them from hiding each other; `places` are those of x along the axis, from 0 to 1.
MethodPoints points_in_row(std::size_t method, const std::vector<double>& x,
                           const std::vector<double>& places, double y, double row_height);

/// The data blocks $participants_METHOD of all groups, and $joined, in which blank lines lie
/// between participants.
std::string participant_data(const std::vector<JoinedPoints>& groups);

/// Plots these blocks of the methods from `first_method` on: thin lines, the thinner the more there
/// are, below hollow points.
std::vector<std::string> participant_layers(const StudyTables& tables, std::size_t first_method);

/// The lane of each point: 0 in the middle of the row, then 1, -1, 2, -2 and so on up to `lanes`
/// lanes, an odd number. Points of one lane lie at least `width` apart, and as near to the middle
/// as that allows; where all lanes are taken, a point goes to where it overlaps least. The same
/// positions give the same lanes.
std::vector<int> point_lanes(const std::vector<double>& positions, double width, std::size_t lanes);

}  // namespace foveola::analysis
