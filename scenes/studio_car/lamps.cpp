#include <cmath>

#include "scenes/studio_car/body_surface.h"
#include "scenes/studio_car/openings.h"
#include "scenes/studio_car/parts.h"
#include "scenes/studio_car/pose.h"

namespace foveola::scenes::car {
namespace {

constexpr double lamp_depth = 0.085;

/// Points `depth` below a row of the sheet, from one share of its columns to another.
std::vector<DVec3> along_row(const Sheet& sheet, double row_share, double from, double to,
                             double depth) {
  const auto row =
      static_cast<std::size_t>(std::lround(row_share * static_cast<double>(sheet.rows - 1)));
  const auto last = static_cast<double>(sheet.columns - 1);
  std::vector<DVec3> points;
  for (auto column = static_cast<std::size_t>(std::lround(from * last));
       column <= static_cast<std::size_t>(std::lround(to * last)); ++column) {
    const DVec3& point = sheet.at(column, row);
    points.push_back(point - depth * skin_normal(point));
  }
  return points;
}

/// Where the sheet is at shares of its columns and rows, looking out along +X or -X.
DMat4 socket(const Sheet& sheet, double column_share, double row_share, double depth,
             double ahead) {
  const std::vector<DVec3> point = along_row(sheet, row_share, column_share, column_share, depth);
  return facing(point.front(), {ahead, 0.0, 0.12});
}

/// A bowl that opens towards +Z.
Shape bowl(double radius, double depth) {
  std::vector<DVec2> outline;
  constexpr int steps = 14;
  for (int i = 0; i <= steps; ++i) {
    const double r = radius * i / steps;
    outline.emplace_back(r, depth * (r * r / (radius * radius) - 1.0));
  }
  outline.emplace_back(1.06 * radius, 0.002);
  outline.emplace_back(1.07 * radius, -0.004);
  Shape shape = inside_out(lathe(outline, 40));
  return turned(shape, 90.0, {1, 0, 0});
}

/// A line of light under a lamp's glass.
Shape light_strip(const Sheet& sheet, double row, double from, double to, double depth,
                  double radius) {
  return tube(along_row(sheet, row, from, to, depth), radius, 10);
}

}  // namespace

std::vector<Part> headlights(const Body& body, const CarMaterials& m) {
  const Sheet& nose = body.nose;
  Shape reflectors;
  Shape rings;
  Shape lenses;
  for (const double column : {0.79, 0.88}) {
    const DMat4 pose = socket(nose, column, 0.775, 0.055, 1.0);
    append(reflectors, transformed(bowl(0.034, 0.03), pose));
    append(lenses, transformed(moved(ellipsoid({0.02, 0.02, 0.014}, 28), {0, 0, -0.012}), pose));
    append(rings, transformed(turned(torus(0.0365, 0.003, 48, 6), 90.0, {1, 0, 0}), pose));
  }
  append(rings, light_strip(nose, 0.635, 0.735, 0.955, 0.03, 0.0045));
  return {{m.gloss_black, beads_along_edges(plate(nose, is_headlight(nose)), 0.0035), 60.0},
          {m.black_plastic, pit(nose, is_headlight(nose), lamp_depth), 50.0},
          {m.chrome, on_both_sides(reflectors), 40.0},
          {m.lamp, on_both_sides(rings), 60.0},
          {m.lamp_glass, on_both_sides(lenses), 60.0},
          {m.lamp_glass, plate(nose, is_headlight(nose), 0.003), 60.0}};
}

std::vector<Part> tail_lights(const Body& body, const CarMaterials& m) {
  const Sheet& tail = body.tail;
  Shape strips;
  for (const double row : {0.75, 0.85}) {
    append(strips, light_strip(tail, row, 0.05, 0.31, 0.025, 0.005));
  }
  Shape reflectors;
  for (const double column : {0.12, 0.2, 0.28}) {
    append(reflectors, transformed(bowl(0.026, 0.02), socket(tail, column, 0.8, 0.03, -1.0)));
  }
  return {{m.black_plastic, pit(tail, is_tail_light(tail), 0.06), 50.0},
          {m.chrome, on_both_sides(reflectors), 40.0},
          {m.red_lamp, on_both_sides(strips), 60.0},
          {m.red_glass, plate(tail, is_tail_light(tail), 0.003), 60.0}};
}

}  // namespace foveola::scenes::car
