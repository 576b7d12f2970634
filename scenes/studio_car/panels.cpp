#include "scenes/studio_car/panels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scenes/studio_car/body_surface.h"

namespace foveola::scenes::car {
namespace {

using Index = std::uint32_t;

/// Each open edge's end by its start; the shape lies on the left of the way between them, seen from
/// outside.
std::map<Index, Index> open_edges(const Shape& shape) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [a, b, c] : shape.triangles) {
    for (const auto& edge : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      ++edges[edge];
    }
  }
  std::map<Index, Index> open;
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge.second, edge.first})) {
      open[edge.first] = edge.second;
    }
  }
  return open;
}

DVec3 interpolated(const DVec3& a, const DVec3& b, double t) { return (1.0 - t) * a + t * b; }

/// How far along the line each of its points is, from 0 to 1.
std::vector<double> shares_of_length(const std::vector<DVec3>& line) {
  std::vector<double> lengths = {0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    lengths.push_back(lengths.back() + glm::distance(line[i - 1], line[i]));
  }
  for (double& length : lengths) {
    length /= lengths.back();
  }
  return lengths;
}

}  // namespace

std::vector<double> even(double from, double to, int cells) {
  std::vector<double> numbers;
  for (int i = 0; i <= cells; ++i) {
    numbers.push_back(std::lerp(from, to, static_cast<double>(i) / cells));
  }
  return numbers;
}

std::vector<double> falling(std::vector<double> numbers, double apart) {
  std::sort(numbers.begin(), numbers.end(), std::greater<>());
  std::vector<double> result = {numbers.front()};
  for (const double number : numbers) {
    if (result.back() - number > apart) {
      result.push_back(number);
    }
  }
  result.back() = numbers.back();
  return result;
}

std::vector<DVec3> Sheet::row(std::size_t row) const {
  const auto first = points.begin() + static_cast<std::ptrdiff_t>(row * columns);
  return {first, first + static_cast<std::ptrdiff_t>(columns)};
}

std::vector<DVec3> Sheet::column(std::size_t column) const {
  std::vector<DVec3> result;
  for (std::size_t row = 0; row < rows; ++row) {
    result.push_back(at(column, row));
  }
  return result;
}

Sheet sheet(const std::vector<double>& us, const std::vector<double>& vs,
            const std::function<DVec3(double u, double v)>& position) {
  Sheet net{us.size(), vs.size(), {}};
  for (const double v : vs) {
    for (const double u : us) {
      net.points.push_back(on_skin(position(u, v)));
    }
  }
  return net;
}

Sheet sheet_between(const std::vector<DVec3>& bottom, const std::vector<DVec3>& top,
                    const std::vector<DVec3>& left, const std::vector<DVec3>& right) {
  const std::vector<double> us = shares_of_length(top);
  const std::vector<double> vs = shares_of_length(left);
  Sheet net{us.size(), vs.size(), {}};
  for (std::size_t row = 0; row < vs.size(); ++row) {
    for (std::size_t column = 0; column < us.size(); ++column) {
      const double u = us[column];
      const double v = vs[row];
      const DVec3 across = interpolated(left[row], right[row], u);
      const DVec3 along = interpolated(bottom[column], top[column], v);
      const DVec3 both = interpolated(interpolated(bottom.front(), bottom.back(), u),
                                      interpolated(top.front(), top.back(), u), v);
      net.points.push_back(on_skin(across + along - both));
    }
  }
  return net;
}

Shape plate(const Sheet& sheet, const Cells& cells, double depth) {
  Shape shape;
  for (const DVec3& point : sheet.points) {
    shape.positions.push_back(depth == 0.0 ? point : point - depth * skin_normal(point));
    shape.uvs.emplace_back(point.x, point.y);
  }
  double outwards = 0.0;
  for (std::size_t row = 0; row + 1 < sheet.rows; ++row) {
    for (std::size_t column = 0; column + 1 < sheet.columns; ++column) {
      if (!cells(column, row)) {
        continue;
      }
      const auto a = static_cast<Index>(row * sheet.columns + column);
      const auto above = static_cast<Index>(a + sheet.columns);
      shape.triangles.push_back({a, a + 1, above + 1});
      shape.triangles.push_back({a, above + 1, above});
      const DVec3 across = glm::cross(sheet.points[a + 1] - sheet.points[above],
                                      sheet.points[above + 1] - sheet.points[a]);
      outwards += glm::dot(across, skin_normal(sheet.points[a]));
    }
  }
  return outwards < 0.0 ? inside_out(shape) : shape;
}

Shape plate(const Sheet& sheet, double depth) {
  return plate(sheet, [](std::size_t, std::size_t) { return true; }, depth);
}

Shape with_folded_edges(Shape shape, double fold) {
  constexpr double bevel = 0.0012;
  const std::map<Index, Index> open = open_edges(shape);
  std::map<Index, DVec3> outwards;
  for (const auto& [from, to] : open) {
    const DVec3 along = shape.positions[to] - shape.positions[from];
    const DVec3 away = glm::cross(along, skin_normal(shape.positions[from]));
    for (const Index end : {from, to}) {
      outwards[end] += glm::length(away) > 0.0 ? glm::normalize(away) : DVec3(0.0);
    }
  }
  std::map<Index, Index> bevelled;
  for (const auto& [vertex, away] : outwards) {
    const DVec3 edge = shape.positions[vertex];
    const DVec3 aside = bevel * glm::normalize(away);
    const DVec3 inwards = -skin_normal(edge);
    bevelled[vertex] = static_cast<Index>(shape.positions.size());
    shape.positions.push_back(edge + aside + bevel * inwards);
    shape.positions.push_back(edge + aside + fold * inwards);
    shape.uvs.insert(shape.uvs.end(), 2, shape.uvs[vertex]);
  }
  for (const auto& [from, to] : open) {
    const Index a = bevelled[from];
    const Index b = bevelled[to];
    shape.triangles.push_back({to, from, a});
    shape.triangles.push_back({to, a, b});
    shape.triangles.push_back({b, a, a + 1});
    shape.triangles.push_back({b, a + 1, b + 1});
  }
  return shape;
}

Shape pit(const Sheet& sheet, const Cells& cells, double depth) {
  Shape shape = plate(sheet, cells, depth);
  std::map<Index, Index> rims;
  const std::map<Index, Index> open = open_edges(shape);
  for (const auto& [from, to] : open) {
    rims[from] = static_cast<Index>(shape.positions.size());
    shape.positions.push_back(sheet.points[from]);
    shape.uvs.push_back(shape.uvs[from]);
  }
  for (const auto& [from, to] : open) {
    shape.triangles.push_back({to, from, rims[from]});
    shape.triangles.push_back({to, rims[from], rims[to]});
  }
  return shape;
}

Shape beads_along_edges(const Shape& shape, double radius) {
  std::map<Index, Index> open = open_edges(shape);
  Shape beads;
  while (!open.empty()) {
    auto edge = open.begin();
    std::vector<DVec3> path = {shape.positions[edge->first]};
    while (edge != open.end()) {
      const Index next = edge->second;
      open.erase(edge);
      path.push_back(shape.positions[next]);
      edge = open.find(next);
    }
    append(beads, tube(path, radius, 6));
  }
  return beads;
}

Shape on_both_sides(const Shape& shape) {
  Shape both = shape;
  append(both, scaled(shape, {1.0, 1.0, -1.0}));
  return both;
}

}  // namespace foveola::scenes::car
