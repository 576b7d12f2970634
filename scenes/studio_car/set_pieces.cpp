// What stands along a studio's walls: boards, paper rolls, boxes, a fire extinguisher.
#include <array>
#include <cmath>

#include "scenes/studio_car/studio.h"

namespace foveola::scenes::studio {
namespace {

/// Two boards that meet at an angle on the origin, black outside, white inside.
std::vector<Part> folding_board(const Materials& m) {
  constexpr double width = 1.2;
  constexpr double height = 2.4;
  constexpr double thickness = 0.025;
  Shape black;
  Shape white;
  for (const double side : {-1.0, 1.0}) {
    const auto put = [&](const Shape& shape) { return turned(shape, -24.0 * side); };
    const double middle_x = side * (0.5 * width + 0.015);
    const Shape half = rounded_box({width, height, thickness}, 0.004, 2);
    append(white, put(moved(half, {middle_x, 0.5 * height + 0.004, 0.0})));
    append(black, put(moved(half, {middle_x, 0.5 * height + 0.004, -thickness})));
  }
  return {{m.black_cloth, black, 45.0}, {m.white_paint, white, 45.0}};
}

/// A roll of background paper upright on the origin, its core showing at the top.
Shape paper_roll(double radius, double height) {
  constexpr double core = 0.03;
  return lathe({{0.0, 0.004},
                {radius - 0.003, 0.004},
                {radius, 0.007},
                {radius, height - 0.003},
                {radius - 0.003, height},
                {core, height},
                {core, height - 0.25},
                {0.0, height - 0.25}},
               48);
}

std::vector<Part> paper_rolls(const Materials& m) {
  Shape rail;
  for (const double y : {0.3, 1.9}) {
    append(rail, tube({{-0.75, y, 0.18}, {0.75, y, 0.18}}, 0.014, 14));
    for (const double x : {-0.74, 0.74}) {
      append(rail, tube({{x, y, 0.185}, {x, y, -0.09}}, 0.012, 14));
    }
  }
  std::vector<Part> parts = {{m.black_steel, rail, 45.0}};
  const std::array<int, 6> papers = {m.backdrop, m.black_cloth, m.white_paint,
                                     m.sandbag,  m.backdrop,    m.car.lining};
  double x = -0.6;
  for (std::size_t i = 0; i < papers.size(); ++i) {
    const double radius = 0.06 + 0.015 * static_cast<double>(i % 3);
    const double height = 2.72 - 0.18 * static_cast<double>(i % 2);
    parts.push_back({papers[i], moved(paper_roll(radius, height), {x, 0.0, 0.05}), 40.0});
    x += 0.23;
  }
  return parts;
}

/// Wooden boxes with grip holes' plates, stacked on the origin.
std::vector<Part> wooden_boxes(const Materials& m) {
  Shape boxes;
  Shape grips;
  double y = 0.0;
  for (const double height : {0.2, 0.2, 0.1, 0.05}) {
    const double turn_deg = 40.0 * y;
    append(boxes, moved(turned(rounded_box({0.5, height - 0.002, 0.3}, 0.006, 3), turn_deg),
                        {0.0, y + 0.5 * height, 0.0}));
    for (const double side : {-1.0, 1.0}) {
      const Shape grip = rounded_box({0.004, 0.4 * height, 0.11}, 0.0015, 2);
      append(grips, moved(turned(moved(grip, {0.25 * side, 0.0, 0.0}), turn_deg),
                          {0.0, y + 0.55 * height, 0.0}));
    }
    y += height;
  }
  return {{m.wood, with_uv_scale(boxes, 1.5), 45.0}, {m.black_cloth, grips, 45.0}};
}

/// On a wall behind -Z, its foot `height` above the floor.
std::vector<Part> fire_extinguisher(const Materials& m, double height) {
  std::vector<DVec2> outline = {{0.0, 0.0}, {0.07, 0.0}, {0.078, 0.006}};
  constexpr int steps = 10;
  for (int i = 0; i <= steps; ++i) {
    const double angle = radians(90.0) * i / steps;
    outline.emplace_back(0.02 + 0.058 * std::cos(angle), 0.4 + 0.058 * std::sin(angle));
  }
  outline.insert(outline.end(), {{0.02, 0.48}, {0.0, 0.48}});
  Shape black = moved(rounded_box({0.035, 0.03, 0.13}, 0.008, 3), {0.0, 0.51, 0.03});
  append(black, tube({{0.02, 0.49, 0.0}, {0.09, 0.44, 0.02}, {0.1, 0.3, 0.02}, {0.09, 0.12, 0.02}},
                     0.011, 14));
  append(black, moved(rounded_box({0.1, 0.05, 0.03}, 0.008, 2), {0.0, 0.25, -0.085}));
  return placed({{m.red_lacquer, lathe(outline, 48), 40.0}, {m.car.rubber, black, 45.0}}, 0.0,
                {0.0, height, 0.0});
}

}  // namespace

void add_set_pieces(Model& model, const Materials& m) {
  add_object(model, "Folding board", placed(folding_board(m), 172.0, {-1.6, 0.0, 6.7}));
  add_object(model, "Paper rolls", placed(paper_rolls(m), 180.0, {7.0, 0.0, half_room - 0.1}));
  add_object(model, "Wooden boxes", placed(wooden_boxes(m), 25.0, {2.3, 0.0, 5.6}));
  add_object(model, "Fire extinguisher",
             placed(fire_extinguisher(m, 0.9), 90.0, {-half_room + 0.1, 0.0, 2.9}));
}

}  // namespace foveola::scenes::studio
