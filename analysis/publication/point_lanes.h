// Points of one row beside each other, so that none hides another.
#pragma once

#include <cstddef>
#include <vector>

namespace foveola::analysis {

/// The lane of each point: 0 in the middle of the row, then 1, -1, 2, -2 and so on up to `lanes`
/// lanes, an odd number. Points of one lane lie at least `width` apart, and as near to the middle
/// as that allows; where all lanes are taken, a point goes to where it overlaps least. The same
/// positions give the same lanes.
std::vector<int> point_lanes(const std::vector<double>& positions, double width, std::size_t lanes);

}  // namespace foveola::analysis
