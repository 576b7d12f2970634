#include "analysis/publication/point_lanes.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace foveola::analysis {

std::vector<int> point_lanes(const std::vector<double>& positions, double width,
                             std::size_t lanes) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return positions[a] < positions[b]; });
  std::vector<double> last(lanes, -std::numeric_limits<double>::infinity());
  std::vector<int> result(positions.size());
  for (const std::size_t point : order) {
    auto lane = std::find_if(last.begin(), last.end(),
                             [&](double before) { return before + width <= positions[point]; });
    if (lane == last.end()) {
      lane = std::min_element(last.begin(), last.end());
    }
    *lane = positions[point];
    const auto from_middle = static_cast<int>(lane - last.begin());
    result[point] = from_middle % 2 == 1 ? (from_middle + 1) / 2 : -from_middle / 2;
  }
  return result;
}

}  // namespace foveola::analysis
