#include "scenes/modelling/shapes.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/angles.h"

namespace foveola::scenes {
namespace {

using std::numbers::pi;

std::uint32_t add_vertex(Shape& shape, const DVec3& position, const DVec2& uv) {
  shape.positions.push_back(position);
  shape.uvs.push_back(uv);
  return static_cast<std::uint32_t>(shape.positions.size() - 1);
}

/// The vertices of a grid of columns * rows cells are the last ones of the shape, row by row.
void add_grid_triangles(Shape& shape, int columns, int rows) {
  const auto width = static_cast<std::uint32_t>(columns + 1);
  const auto first = static_cast<std::uint32_t>(shape.positions.size()) -
                     width * static_cast<std::uint32_t>(rows + 1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t a =
          first + static_cast<std::uint32_t>(row) * width + static_cast<std::uint32_t>(column);
      shape.triangles.push_back({a, a + 1, a + width + 1});
      shape.triangles.push_back({a, a + width + 1, a + width});
    }
  }
}

/// Where the grid lines of a rounded face lie on one axis: a point of the inner box in [-1, 1], and
/// the tangent of the angle by which the surface has turned there.
std::vector<DVec2> rounded_grid_lines(int steps, int cells) {
  std::vector<DVec2> lines;
  const auto turn = [&](int i) { return std::tan(0.25 * std::numbers::pi * i / steps); };
  for (int i = steps; i > 0; --i) {
    lines.emplace_back(-1.0, -turn(i));
  }
  for (int i = 0; i <= cells; ++i) {
    lines.emplace_back(2.0 * i / cells - 1.0, 0.0);
  }
  for (int i = 1; i <= steps; ++i) {
    lines.emplace_back(1.0, turn(i));
  }
  return lines;
}

/// The +Z face of a rounded box, turned by `face_to_box`: a grid on the face of the inner box,
/// pushed out by the radius.
Shape rounded_face(const DVec3& inner_half, double radius, const std::vector<DVec2>& grid_lines,
                   const DMat4& face_to_box, const DVec2& face_inner_half) {
  Shape face;
  for (const DVec2& y : grid_lines) {
    for (const DVec2& x : grid_lines) {
      const DVec3 outwards = glm::normalize(DVec3(x.y, y.y, 1.0));
      const DVec3 inner = DVec3(face_to_box * glm::dvec4(x.x, y.x, 1.0, 0.0)) * inner_half;
      const DVec3 position = inner + radius * DVec3(face_to_box * glm::dvec4(outwards, 0.0));
      add_vertex(face, position,
                 {x.x * face_inner_half.x + radius * x.y, y.x * face_inner_half.y + radius * y.y});
    }
  }
  const int cells = static_cast<int>(grid_lines.size()) - 1;
  add_grid_triangles(face, cells, cells);
  return face;
}

/// Directions across a path at each of its points, carried along without twist.
std::vector<DVec3> normals_along(const std::vector<DVec3>& path, std::vector<DVec3>& tangents) {
  tangents.clear();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const DVec3& before = path[i == 0 ? 0 : i - 1];
    const DVec3& after = path[i + 1 == path.size() ? i : i + 1];
    tangents.push_back(glm::normalize(after - before));
  }
  const DVec3 helper = std::abs(tangents[0].y) < 0.9 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
  std::vector<DVec3> normals = {glm::normalize(glm::cross(helper, tangents[0]))};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const DVec3 carried = normals.back() - glm::dot(normals.back(), tangents[i]) * tangents[i];
    normals.push_back(glm::normalize(carried));
  }
  return normals;
}

}  // namespace

void append(Shape& to, const Shape& from) {
  const auto offset = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
  for (const auto& [a, b, c] : from.triangles) {
    to.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

Shape transformed(Shape shape, const DMat4& transform) {
  for (DVec3& position : shape.positions) {
    position = DVec3(transform * glm::dvec4(position, 1.0));
  }
  const bool mirrors = glm::determinant(glm::dmat3(transform)) < 0.0;
  return mirrors ? inside_out(std::move(shape)) : shape;
}

Shape moved(Shape shape, const DVec3& offset) {
  for (DVec3& position : shape.positions) {
    position += offset;
  }
  return shape;
}

Shape turned(Shape shape, double angle_deg) {
  return turned(std::move(shape), angle_deg, DVec3(0, 1, 0));
}

Shape turned(Shape shape, double angle_deg, const DVec3& axis) {
  return transformed(std::move(shape), glm::rotate(DMat4(1.0), radians(angle_deg), axis));
}

Shape scaled(Shape shape, const DVec3& factors) {
  return transformed(std::move(shape), glm::scale(DMat4(1.0), factors));
}

Shape with_uv_scale(Shape shape, double factor) {
  for (DVec2& uv : shape.uvs) {
    uv *= factor;
  }
  return shape;
}

Shape with_projected_uvs(Shape shape, const DVec3& u_direction, const DVec3& v_direction) {
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    const DVec3& position = shape.positions[i];
    shape.uvs[i] = {glm::dot(position, u_direction), glm::dot(position, v_direction)};
  }
  return shape;
}

Shape deformed(Shape shape, const std::function<DVec3(const DVec3&)>& position) {
  for (DVec3& p : shape.positions) {
    p = position(p);
  }
  return shape;
}

Shape inside_out(Shape shape) {
  for (auto& triangle : shape.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return shape;
}

Shape rectangle(const DVec3& corner, const DVec3& edge_u, const DVec3& edge_v) {
  const double width = glm::length(edge_u);
  const double height = glm::length(edge_v);
  Shape shape;
  add_vertex(shape, corner, {0.0, height});
  add_vertex(shape, corner + edge_u, {width, height});
  add_vertex(shape, corner + edge_v, {0.0, 0.0});
  add_vertex(shape, corner + edge_u + edge_v, {width, 0.0});
  shape.triangles = {{0, 1, 3}, {0, 3, 2}};
  return shape;
}

Shape picture(const DVec3& corner, const DVec3& edge_u, const DVec3& edge_v) {
  Shape shape = rectangle(corner, edge_u, edge_v);
  shape.uvs = {{0.0, 1.0}, {1.0, 1.0}, {0.0, 0.0}, {1.0, 0.0}};
  return shape;
}

Shape box(const DVec3& lower, const DVec3& upper) {
  const DVec3 size = upper - lower;
  const DVec3 x(size.x, 0, 0);
  const DVec3 y(0, size.y, 0);
  const DVec3 z(0, 0, size.z);
  Shape shape = rectangle(lower + z, x, y);
  append(shape, rectangle(lower + x, -x, y));
  append(shape, rectangle(lower + x + z, -z, y));
  append(shape, rectangle(lower, z, y));
  append(shape, rectangle(lower + y + z, x, -z));
  append(shape, rectangle(lower, x, z));
  return shape;
}

Shape box(const DVec3& size) { return box(-0.5 * size, 0.5 * size); }

Shape rounded_box(const DVec3& size, double radius, int steps, int cells) {
  const DVec3 inner_half = 0.5 * size - DVec3(radius);
  assert(glm::min(inner_half.x, glm::min(inner_half.y, inner_half.z)) >= 0.0);
  const std::vector<DVec2> lines = rounded_grid_lines(steps, cells);
  const DMat4 identity(1.0);
  const DVec3 x(1, 0, 0);
  const DVec3 y(0, 1, 0);
  const DVec2 front(inner_half.x, inner_half.y);
  const DVec2 side(inner_half.z, inner_half.y);
  const DVec2 top(inner_half.x, inner_half.z);
  Shape shape;
  for (const double angle_deg : {0.0, 180.0}) {
    const DMat4 turn = glm::rotate(identity, radians(angle_deg), y);
    append(shape, rounded_face(inner_half, radius, lines, turn, front));
  }
  for (const double angle_deg : {90.0, -90.0}) {
    const DMat4 turn = glm::rotate(identity, radians(angle_deg), y);
    const DMat4 tilt = glm::rotate(identity, radians(angle_deg), x);
    append(shape, rounded_face(inner_half, radius, lines, turn, side));
    append(shape, rounded_face(inner_half, radius, lines, tilt, top));
  }
  return shape;
}

Shape patch(int columns, int rows, const SurfaceFunction& position) {
  Shape shape;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double u = static_cast<double>(column) / columns;
      const double v = static_cast<double>(row) / rows;
      add_vertex(shape, position(u, v), {u, v});
    }
  }
  add_grid_triangles(shape, columns, rows);
  return shape;
}

Shape lathe(const std::vector<DVec2>& outline, int segments) {
  Shape shape;
  double length = 0.0;
  for (std::size_t row = 0; row < outline.size(); ++row) {
    length += row > 0 ? glm::distance(outline[row], outline[row - 1]) : 0.0;
    for (int column = 0; column <= segments; ++column) {
      const double turn = static_cast<double>(column) / segments;
      const double angle = 2.0 * pi * turn;
      const DVec3 position(outline[row].x * std::sin(angle), outline[row].y,
                           outline[row].x * std::cos(angle));
      add_vertex(shape, position, {turn, length});
    }
  }
  add_grid_triangles(shape, segments, static_cast<int>(outline.size()) - 1);
  return shape;
}

Shape cylinder(double radius, double height, int segments) {
  return cone(radius, radius, height, segments);
}

Shape cone(double bottom_radius, double top_radius, double height, int segments) {
  return lathe({{0.0, 0.0}, {bottom_radius, 0.0}, {top_radius, height}, {0.0, height}}, segments);
}

Shape ellipsoid(const DVec3& radii, int segments) {
  std::vector<DVec2> outline;
  const int rows = segments / 2;
  for (int i = 0; i <= rows; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / rows - 0.5);
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  return scaled(lathe(outline, segments), radii);
}

Shape torus(double ring_radius, double tube_radius, int ring_segments, int tube_segments) {
  std::vector<DVec2> outline;
  for (int i = 0; i <= tube_segments; ++i) {
    const double angle = 2.0 * pi * i / tube_segments;
    outline.emplace_back(ring_radius + tube_radius * std::cos(angle),
                         tube_radius * std::sin(angle));
  }
  return lathe(outline, ring_segments);
}

Shape tube(const std::vector<DVec3>& path, double radius, int segments) {
  assert(path.size() >= 2);
  std::vector<DVec3> tangents;
  const std::vector<DVec3> normals = normals_along(path, tangents);
  Shape shape;
  double length = 0.0;
  const auto add_ring = [&](std::size_t i, double ring_radius) {
    const DVec3 bitangent = glm::cross(tangents[i], normals[i]);
    for (int column = 0; column <= segments; ++column) {
      const double turn = static_cast<double>(column) / segments;
      const DVec3 across =
          std::cos(2.0 * pi * turn) * normals[i] + std::sin(2.0 * pi * turn) * bitangent;
      add_vertex(shape, path[i] + ring_radius * across, {turn * 2.0 * pi * radius, length});
    }
  };
  add_ring(0, 0.0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    length += i > 0 ? glm::distance(path[i], path[i - 1]) : 0.0;
    add_ring(i, radius);
  }
  add_ring(path.size() - 1, 0.0);
  add_grid_triangles(shape, segments, static_cast<int>(path.size()) + 1);
  return shape;
}

Shape arch(const ArchBay& bay, int segments) {
  const double radius = 0.5 * bay.opening_width;
  const double half_bay = 0.5 * bay.bay_width;
  assert(bay.springing_height + radius < bay.height && radius < half_bay);
  // The opening's edge from its left foot over the crown to its right foot, and above each of its
  // points a point of the wall's outline.
  std::vector<DVec2> inner = {{-radius, 0.0}};
  std::vector<DVec2> outer = {{-half_bay, 0.0}};
  for (int i = 0; i <= segments; ++i) {
    const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / segments);
    const DVec2 on_arch(radius * std::cos(angle), bay.springing_height + radius * std::sin(angle));
    const double side = glm::clamp(on_arch.x / radius * 1.5, -1.0, 1.0);
    inner.push_back(on_arch);
    outer.emplace_back(side * half_bay,
                       i == 0 || i == segments ? bay.springing_height : bay.height);
  }
  inner.emplace_back(radius, 0.0);
  outer.emplace_back(half_bay, 0.0);
  const double half = 0.5 * bay.thickness;
  Shape shape;
  const auto add_strip = [&](const auto& left, const auto& right) {
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const DVec3 a = left(i);
      const DVec3 b = right(i);
      add_vertex(shape, a, {a.x, -a.y});
      add_vertex(shape, b, {b.x, -b.y});
    }
    add_grid_triangles(shape, 1, static_cast<int>(inner.size()) - 1);
  };
  add_strip([&](std::size_t i) { return DVec3(outer[i], half); },
            [&](std::size_t i) { return DVec3(inner[i], half); });
  add_strip([&](std::size_t i) { return DVec3(inner[i], -half); },
            [&](std::size_t i) { return DVec3(outer[i], -half); });
  double length = 0.0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    length += i > 0 ? glm::distance(inner[i], inner[i - 1]) : 0.0;
    add_vertex(shape, DVec3(inner[i], half), {bay.thickness, length});
    add_vertex(shape, DVec3(inner[i], -half), {0.0, length});
  }
  add_grid_triangles(shape, 1, static_cast<int>(inner.size()) - 1);
  return shape;
}

}  // namespace foveola::scenes
