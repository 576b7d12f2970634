#include "analysis/publication/figures/participant_points.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "analysis/publication/figures/figure_drawing.h"

namespace foveola::analysis {

MethodPoints points_in_row(std::size_t method, const std::vector<double>& x,
                           const std::vector<double>& places, double y, double row_height) {
  constexpr double point_width = 6.0;  // In SVG units, as the next.
  constexpr double axis_width = 520.0;
  constexpr std::size_t lanes = 7;
  MethodPoints points{method, x, {}};
  for (const int lane : point_lanes(places, point_width / axis_width, lanes)) {
    points.y.push_back(y + lane * point_width / row_height);
  }
  return points;
}

std::string participant_data(const std::vector<JoinedPoints>& groups) {
  std::map<std::size_t, std::string> of_methods;
  std::string joined;
  for (const JoinedPoints& group : groups) {
    for (std::size_t i = 0; !group.empty() && i < group.front().x.size(); ++i) {
      for (const MethodPoints& points : group) {
        const std::string point = fmt::format("{} {}\n", points.x[i], points.y[i]);
        of_methods[points.method] += point;
        joined += point;
      }
      joined += "\n";
    }
  }
  std::string data = "$joined << END\n" + joined + "END\n";
  for (const auto& [method, points] : of_methods) {
    data += fmt::format("$participants_{} << END\n{}END\n", method, points);
  }
  return data;
}

std::vector<std::string> participant_layers(const StudyTables& tables, std::size_t first_method) {
  constexpr double widest = 0.8;
  constexpr double widest_together = 40.0;
  const std::size_t methods = tables.set.methods.size();
  std::vector<std::string> layers;
  if (methods - first_method > 1) {
    layers.push_back(fmt::format(
        "$joined using 1:2 with lines linewidth {} linecolor rgb '{}' notitle",
        std::min(widest, widest_together / static_cast<double>(tables.set.participants.size())),
        palette::participant.rgb));
  }
  for (std::size_t method = first_method; method < methods; ++method) {
    layers.push_back(
        fmt::format("$participants_{} using 1:2 with points pointtype {} pointsize 0.65 linecolor "
                    "rgb '{}' notitle",
                    method, hollow_point(method), method_color(method).rgb));
  }
  return layers;
}

std::vector<int> point_lanes(const std::vector<double>& positions, double width,
                             std::size_t lanes) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return positions[a] < positions[b]; });
  std::vector<double> last(lanes, -std::numeric_limits<double>::infinity());
  std::vector<int> result(positions.size());
  for (const std::size_t point : order) {
    auto lane = std::ranges::find_if(
        last, [&](double before) { return before + width <= positions[point]; });
    if (lane == last.end()) {
      lane = std::ranges::min_element(last);
    }
    *lane = positions[point];
    const auto from_middle = static_cast<int>(lane - last.begin());
    result[point] = from_middle % 2 == 1 ? (from_middle + 1) / 2 : -from_middle / 2;
  }
  return result;
}

}  // namespace foveola::analysis
