// The board and everything else that hangs on the school room's walls.
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/schoolroom/layout.h"
#include "scenes/schoolroom/parts.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

/// A leaf of the board from x = 0 to `width`, from y = 0 to `height`, its face at z = 0 towards +Z.
struct Leaf {
  Shape face;
  Shape frame;
};

Leaf board_leaf(double width, double height) {
  constexpr double border = 0.03;
  Leaf leaf;
  leaf.face = picture({border, border, 0.0}, {width - 2.0 * border, 0.0, 0.0},
                      {0.0, height - 2.0 * border, 0.0});
  for (const double y : {0.5 * border, height - 0.5 * border}) {
    append(leaf.frame, moved(rounded_box({width, border, 0.03}, 0.006, 2), {0.5 * width, y, 0.0}));
  }
  for (const double x : {0.5 * border, width - 0.5 * border}) {
    append(leaf.frame, moved(rounded_box({border, height - 2.0 * border, 0.03}, 0.006, 2),
                             {x, 0.5 * height, 0.0}));
  }
  append(leaf.frame, box({0.01, 0.01, -0.014}, {width - 0.01, height - 0.01, -0.003}));
  return leaf;
}

/// From the wall at z = 0 that faces +Z to the wall with the board.
Shape on_board_wall(const Shape& shape) {
  return moved(turned(shape, -90.0), {half_x - 0.012, 0.0, 0.0});
}

Shape on_back_wall(const Shape& shape) {
  return moved(turned(shape, 90.0), {-half_x + 0.012, 0.0, 0.0});
}

Shape on_door_wall(const Shape& shape) {
  return moved(turned(shape, 180.0), {0.0, 0.0, half_z - 0.012});
}

/// A sheet of paper from x = 0, y = 0, its lower corners lifting; uvs of sheet `number`.
Shape pinned_sheet(double width, double height, int number, double lift) {
  Shape sheet = patch(5, 7, [&](double u, double v) {
    const double free = 1.0 - v;
    return DVec3(width * (u - 0.5), -height * free,
                 0.002 + lift * free * free * (0.4 + 2.4 * (u - 0.5) * (u - 0.5)));
  });
  for (DVec2& uv : sheet.uvs) {
    uv = {(number % sheets_across + uv.x) / sheets_across,
          (number / sheets_across % sheets_down + 1.0 - uv.y) / sheets_down};
  }
  return sheet;
}

Shape pin() {
  Shape shape = moved(ellipsoid({0.006, 0.006, 0.004}, 12), {0.0, 0.0, 0.008});
  append(shape, moved(turned(cylinder(0.002, 0.008, 8), 90.0, {1, 0, 0}), {0.0, 0.0, 0.0}));
  return shape;
}

/// The board is hung with chalk, a sponge and a long ruler in its tray.
void add_tray(Model& model, const Materials& m, double y) {
  Shape tray = patch(1, 6, [&](double u, double v) {
    const double angle = std::numbers::pi * (1.0 + v);
    return DVec3(2.4 * (u - 0.5), 0.028 * std::sin(angle), 0.06 - 0.04 * std::cos(angle));
  });
  append(tray, inside_out(moved(tray, {0.0, -0.003, 0.0})));
  append(tray, moved(rounded_box({2.4, 0.012, 0.012}, 0.004, 1), {0.0, 0.0, 0.1}));
  append(tray, moved(rounded_box({2.4, 0.012, 0.02}, 0.004, 1), {0.0, 0.0, 0.015}));
  Shape sticks;
  Pcg32 random = generator(model.stream(630));
  for (int i = 0; i < 14; ++i) {
    const Shape stick =
        turned(cone(0.0055, 0.0045, 0.05 + 0.03 * random.uniform(), 12), 90.0, {0, 0, 1});
    const double turn_deg = 30.0 * (random.uniform() - 0.5);
    append(sticks, moved(turned(stick, turn_deg), {1.1 - 1.9 * random.uniform(), -0.02, 0.06}));
  }
  const Shape sponge = moved(rounded_box({0.14, 0.06, 0.07}, 0.015, 3), {-0.95, 0.008, 0.06});
  const auto put = [&](const Shape& shape) { return on_board_wall(moved(shape, {0.0, y, 0.0})); };
  add_object(
      model, "Chalk tray",
      {{m.steel, put(tray), 60.0}, {m.chalk, put(sticks), 50.0}, {m.yellow, put(sponge), 50.0}});
}

void add_map(Model& model, const Materials& m) {
  constexpr double width = 1.9;
  constexpr double height = 0.95;
  const DVec3 middle(2.75, 2.3, 0.05);
  // A sheet that was rolled up for long does not hang flat.
  Shape sheet = patch(4, 16, [&](double u, double v) {
    return DVec3(width * (u - 0.5), height * (v - 1.0),
                 0.012 * std::cos(2.6 * std::numbers::pi * v));
  });
  for (DVec2& uv : sheet.uvs) {
    uv.y = 1.0 - uv.y;
  }
  const Shape back = inside_out(moved(sheet, {0.0, 0.0, -0.002}));
  Shape rods;
  for (const double y : {0.0, -height}) {
    append(rods, moved(turned(cylinder(0.018, width + 0.08, 20), -90.0, {0, 0, 1}),
                       {-0.5 * width - 0.04, y, 0.0}));
    for (const double side : {-1.0, 1.0}) {
      append(rods,
             moved(ellipsoid({0.02, 0.026, 0.026}, 16), {side * (0.5 * width + 0.05), y, 0.0}));
    }
  }
  Shape cord = tube({{-0.6, 0.0, 0.0}, {0.0, 0.25, -0.03}}, 0.003, 6);
  append(cord, tube({{0.6, 0.0, 0.0}, {0.0, 0.25, -0.03}}, 0.003, 6));
  append(cord, tube({{0.0, 0.25, -0.05}, {0.0, 0.25, -0.015}}, 0.006, 10));
  const auto put = [&](const Shape& shape) {
    return on_door_wall(moved(shape, DVec3(-middle.x, middle.y, middle.z)));
  };
  add_object(model, "Wall map",
             {{m.wall_map, put(sheet), 60.0},
              {m.paper, put(back), 60.0},
              {m.dark_wood, put(rods), 50.0},
              {m.brass, put(cord), 60.0}});
}

void add_clock(Model& model, const Materials& m) {
  constexpr double radius = 0.19;
  Shape rim = turned(torus(radius, 0.022, 56, 14), 90.0, {1, 0, 0});
  rim = moved(rim, {0.0, 0.0, 0.03});
  append(rim, moved(turned(cylinder(radius, 0.028, 56), 90.0, {1, 0, 0}), {0.0, 0.0, 0.0}));
  Shape face =
      moved(turned(lathe({{radius, 0.0}, {0.0, 0.0}}, 56), 90.0, {1, 0, 0}), {0, 0, 0.031});
  for (std::size_t i = 0; i < face.positions.size(); ++i) {
    const DVec3& p = face.positions[i];
    face.uvs[i] = {0.5 + 0.5 * p.x / radius, 0.5 - 0.5 * p.y / radius};
  }
  const auto put = [](const Shape& shape) { return on_board_wall(moved(shape, {0.0, 2.84, 0.0})); };
  add_object(model, "Clock", {{m.black_plastic, put(rim), 50.0}, {m.clock, put(face)}});
}

void add_notice_board(Model& model, const Materials& m) {
  constexpr double width = 2.3;
  constexpr double height = 1.0;
  const DVec3 lower_left(-3.05, 1.45, 0.0);
  const auto put = [&](const Shape& shape) { return on_back_wall(moved(shape, lower_left)); };
  Shape frame;
  for (const double y : {0.0, height}) {
    append(frame,
           moved(rounded_box({width + 0.04, 0.04, 0.03}, 0.008, 2), {0.5 * width, y, 0.015}));
  }
  for (const double x : {0.0, width}) {
    append(frame,
           moved(rounded_box({0.04, height - 0.04, 0.03}, 0.008, 2), {x, 0.5 * height, 0.015}));
  }
  Shape sheets;
  Shape pins;
  Pcg32 random = generator(model.stream(640));
  for (int i = 0; i < 14; ++i) {
    const double lean_deg = 8.0 * (random.uniform() - 0.5);
    const DVec3 top{0.2 + 0.316 * (i % 7) + 0.03 * random.uniform(),
                    height - 0.08 - 0.47 * (i / 7) - 0.05 * random.uniform(), 0.013};
    append(sheets, moved(turned(pinned_sheet(0.24, 0.34, static_cast<int>(random.below(8)), 0.012),
                                lean_deg, {0, 0, 1}),
                         top));
    append(pins, moved(pin(), top - DVec3(0.0, 0.012, 0.0)));
  }
  add_object(model, "Notice board",
             {{m.cork, put(box({0.0, 0.0, 0.0}, {width, height, 0.012}))},
              {m.dark_wood, put(frame), 50.0},
              {m.notices, put(sheets), 60.0},
              {m.red, put(pins), 60.0}});
}

/// Children's drawings pegged to a line above the coats.
void add_drawings(Model& model, const Materials& m) {
  const auto sagging = [](double t) { return 2.62 - 0.1 * 4.0 * t * (1.0 - t); };
  constexpr double from = -1.6;
  constexpr double to = 2.3;
  std::vector<DVec3> line;
  for (int i = 0; i <= 24; ++i) {
    const double t = i / 24.0;
    line.emplace_back(std::lerp(from, to, t), sagging(t), 0.06);
  }
  Shape cord = tube(line, 0.002, 6);
  for (const double x : {from, to}) {
    append(cord, tube({{x, 2.62, 0.0}, {x, 2.62, 0.07}}, 0.004, 8));
  }
  Shape sheets;
  Shape pegs;
  for (int i = 0; i < 8; ++i) {
    const double t = (i + 0.5) / 8.0;
    const DVec3 place(std::lerp(from, to, t), sagging(t), 0.062);
    append(sheets, moved(pinned_sheet(0.32, 0.42, i, 0.02), place));
    for (const double side : {-0.1, 0.1}) {
      append(pegs,
             moved(rounded_box({0.012, 0.06, 0.016}, 0.003, 1), place + DVec3(side, 0.0, 0.0)));
    }
  }
  add_object(model, "Drawings",
             {{m.drawings, on_door_wall(sheets), 60.0},
              {m.brass, on_door_wall(cord), 60.0},
              {m.plywood, on_door_wall(pegs), 50.0}});
}

}  // namespace

void add_board(Model& model, const Materials& m) {
  constexpr double bottom = 1.06;
  constexpr double height = 1.2;
  constexpr double middle_width = 2.34;
  constexpr double wing_width = 1.17;
  constexpr double wing_opening_deg = 24.0;
  const auto put = [](const Shape& shape) {
    return on_board_wall(moved(shape, {0.0, bottom, 0.06}));
  };
  const Leaf middle = board_leaf(middle_width, height);
  const Leaf wing = board_leaf(wing_width, height);
  const DVec3 left_end(-0.5 * middle_width, 0.0, 0.0);
  const auto middle_place = [&](const Shape& shape) { return put(moved(shape, left_end)); };
  const auto left_place = [&](const Shape& shape) {
    const Shape from_hinge = moved(shape, {-wing_width - 0.01, 0.0, 0.0});
    return put(moved(turned(from_hinge, wing_opening_deg), left_end));
  };
  const auto right_place = [&](const Shape& shape) {
    const Shape from_hinge = moved(shape, {0.01, 0.0, 0.0});
    return put(moved(turned(from_hinge, -wing_opening_deg), -left_end));
  };
  Shape frame = middle_place(middle.frame);
  append(frame, left_place(wing.frame));
  append(frame, right_place(wing.frame));
  Shape fittings;
  for (const double side : {-1.0, 1.0}) {
    for (const double y : {0.15, height - 0.2}) {
      append(fittings,
             put(moved(cylinder(0.012, 0.07, 14), {side * 0.5 * middle_width, y, 0.014})));
    }
    append(fittings,
           put(box({side * 0.6 - 0.03, -0.05, -0.06}, {side * 0.6 + 0.03, height + 0.05, -0.014})));
  }
  add_object(model, "Blackboard",
             {{m.board_middle, middle_place(middle.face)},
              {m.board_left, left_place(wing.face)},
              {m.board_right, right_place(wing.face)},
              {m.plywood, frame, 50.0},
              {m.steel, fittings, 50.0}});
  add_tray(model, m, bottom - 0.02);
}

void add_wall_things(Model& model, const Materials& m) {
  add_map(model, m);
  add_clock(model, m);
  add_notice_board(model, m);
  add_drawings(model, m);
  constexpr double strip_width = 4.48;
  const Shape strip =
      picture({-0.5 * strip_width, 2.34, 0.004}, {strip_width, 0.0, 0.0}, {0.0, 0.28, 0.0});
  const Shape card =
      box({-0.5 * strip_width - 0.01, 2.33, 0.0}, {0.5 * strip_width + 0.01, 2.63, 0.003});
  add_object(model, "Alphabet",
             {{m.alphabet, on_board_wall(strip)}, {m.dark_wood, on_board_wall(card)}});
}

}  // namespace foveola::scenes::school
