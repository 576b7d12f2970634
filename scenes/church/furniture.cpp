// What stands in the church to sit on, preach from and celebrate at.
#include <cmath>
#include <numbers>
#include <string>

#include "scenes/church/candles.h"
#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::church {
namespace {

/// An upright picture that faces -X, from its lower middle.
Shape west_picture(const DVec3& foot, double width, double height) {
  return picture(foot - DVec3(0.0, 0.0, 0.5 * width), {0, 0, width}, {0, height, 0});
}

/// A frame of four bars around a picture that faces -X.
Shape west_frame(const DVec3& foot, double width, double height, double bar) {
  const double half = 0.5 * (width + bar);
  Shape frame;
  for (const double side : {-1.0, 1.0}) {
    append(frame, moved(box(DVec3(0.08, height + 2.0 * bar, bar)),
                        foot + DVec3(0.0, 0.5 * height, side * half)));
    append(frame, moved(box(DVec3(0.08, bar, width)),
                        foot + DVec3(0.0, 0.5 * height + side * 0.5 * (height + bar), 0.0)));
  }
  return frame;
}

/// Three painted panels under gables, behind the altar.
void add_retable(std::vector<Part>& parts, const Materials& m, const DVec3& foot) {
  Shape gold = moved(box(DVec3(0.14, 1.75, 3.0)), foot + DVec3(0.1, 0.875, 0.0));
  Shape red_saint;
  Shape blue_saints;
  for (const int panel : {-1, 0, 1}) {
    const DVec3 middle = foot + DVec3(0.02, 0.2, 0.95 * panel);
    append(panel == 0 ? red_saint : blue_saints, west_picture(middle, 0.68, 1.36));
    append(gold, west_frame(middle, 0.68, 1.36, 0.09));
    const double height = panel == 0 ? 0.7 : 0.45;
    const Shape gable = scaled(cone(0.42, 0.0, height, 4), {0.16, 1.0, 1.0});
    append(gold, moved(gable, foot + DVec3(0.1, 1.75, 0.95 * panel)));
    append(gold, moved(ellipsoid({0.06, 0.09, 0.06}, 10),
                       foot + DVec3(0.1, 1.75 + height, 0.95 * panel)));
  }
  parts.push_back({m.gold, gold});
  parts.push_back({m.red_saint, red_saint});
  parts.push_back({m.blue_saint, blue_saints});
}

/// A pew that faces +X, its middle on the origin.
Shape pew(double length) {
  const Shape seat = box({-0.2, 0.4, -0.5 * length}, {0.2, 0.44, 0.5 * length});
  Shape shape = seat;
  const Shape back = box(DVec3(0.03, 0.5, length));
  append(shape, moved(turned(back, 8.0, {0, 0, 1}), {-0.24, 0.66, 0.0}));
  append(shape, moved(rounded_box({0.09, 0.05, length}, 0.02, 1), {-0.28, 0.91, 0.0}));
  append(shape, moved(box(DVec3(0.2, 0.03, length)), {-0.4, 0.72, 0.0}));
  append(shape, moved(box(DVec3(0.14, 0.05, length)), {-0.5, 0.16, 0.0}));
  for (const double side : {-1.0, 1.0}) {
    const double z = side * (0.5 * length + 0.03);
    append(shape, moved(rounded_box({0.5, 0.62, 0.06}, 0.02, 1), {-0.02, 0.31, z}));
    append(shape, moved(rounded_box({0.14, 0.98, 0.06}, 0.02, 1), {-0.27, 0.49, z}));
    append(shape, moved(box(DVec3(0.18, 0.06, 0.08)), {-0.5, 0.1, z}));
    append(shape, moved(ellipsoid({0.06, 0.08, 0.05}, 8), {-0.27, 1.02, z}));
  }
  return shape;
}

/// A vessel or post of eight flat sides, from an outline as lathe's.
Shape octagonal(const std::vector<DVec2>& outline) { return turned(lathe(outline, 8), 22.5); }

Shape pulpit_stairs(const DVec3& foot, double height) {
  constexpr int steps = 9;
  Shape stairs;
  for (int i = 0; i < steps; ++i) {
    const double top = height * (i + 1) / steps;
    const double x = 2.75 - 0.25 * i;
    append(stairs, box(foot + DVec3(x - 0.26, top - 0.22, -0.35), foot + DVec3(x, top, 0.35)));
  }
  for (const double side : {-0.36, 0.36}) {
    append(stairs, tube({foot + DVec3(2.7, 0.95, side), foot + DVec3(0.55, height + 0.95, side)},
                        0.03, 10));
    for (int i = 0; i < steps; i += 2) {
      const double top = height * (i + 1) / steps;
      append(stairs,
             moved(cylinder(0.02, 0.98, 8), foot + DVec3(2.62 - 0.25 * i, top - 0.1, side)));
    }
  }
  return stairs;
}

}  // namespace

void add_altar(Model& model, const Materials& m) {
  const double x = 14.1;
  const double floor = choir_floor + 0.15;
  const double top = floor + 1.0;
  Shape marble = box({x - 1.2, choir_floor, -1.9}, {x + 1.5, floor, 1.9});
  append(marble, box({x - 0.4, floor, -1.2}, {x + 0.4, top - 0.1, 1.2}));
  append(marble, box({x - 0.5, top - 0.1, -1.35}, {x + 0.5, top, 1.35}));
  Shape linen = box({x - 0.51, top, -1.1}, {x + 0.45, top + 0.012, 1.1});
  append(linen, box({x - 0.52, top - 0.16, -1.1}, {x - 0.502, top + 0.012, 1.1}));
  const Shape frontal = west_picture({x - 0.41, floor + 0.02, 0.0}, 2.2, 0.86);
  std::vector<Part> parts = {
      {m.white_marble, with_uv_scale(marble, 0.7)}, {m.linen, linen}, {m.frontal, frontal}};
  Shape shelf = box({x + 0.75, floor, -1.5}, {x + 1.25, top + 0.2, 1.5});
  parts.push_back({m.red_marble, with_uv_scale(shelf, 0.7)});
  add_retable(parts, m, {x + 1.05, top + 0.2, 0.0});
  Candles candles;
  for (const double side : {-1.0, 1.0}) {
    for (const double z : {0.5, 0.75, 1.0}) {
      candles.add_candlestick({x + 0.25, top + 0.012, side * z}, 0.45, 0.3);
    }
  }
  append(candles.brass, moved(box(DVec3(0.03, 0.6, 0.04)), {x + 0.2, top + 0.31, 0.0}));
  append(candles.brass, moved(box(DVec3(0.028, 0.04, 0.32)), {x + 0.2, top + 0.45, 0.0}));
  append(candles.brass, moved(cone(0.11, 0.03, 0.1, 16), {x + 0.2, top + 0.012, 0.0}));
  candles.append_to(parts, m);
  add_object(model, "Altar", parts);
}

void add_pulpit(Model& model, const Materials& m) {
  const DVec3 place(4.0, 0.0, -2.5);
  const double floor = 1.75;
  Shape stone = octagonal({{0.0, 0.0},
                           {0.5, 0.0},
                           {0.5, 0.15},
                           {0.3, 0.25},
                           {0.2, 0.45},
                           {0.2, 1.15},
                           {0.3, 1.3},
                           {0.62, floor - 0.12},
                           {0.72, floor - 0.06},
                           {0.72, floor},
                           {0.6, floor + 0.04},
                           {0.6, floor + 1.0},
                           {0.72, floor + 1.04},
                           {0.72, floor + 1.12},
                           {0.5, floor + 1.12},
                           {0.5, floor},
                           {0.0, floor}});
  Shape saints;
  Shape shafts;
  const double to_face = 0.6 * std::cos(std::numbers::pi / 8.0) + 0.012;
  for (int i = 0; i < 8; ++i) {
    const Shape panel = picture({-0.17, floor + 0.12, to_face}, {0.34, 0, 0}, {0, 0.8, 0});
    append(saints, turned(panel, 45.0 * i));
    append(shafts, turned(moved(shaft(0.03, 0.98, 8), {0.0, floor + 0.05, 0.61}), 45.0 * i + 22.5));
  }
  // The sounding board hangs on a panel before the column.
  Shape wood = moved(octagonal({{0.0, 0.0},
                                {0.7, 0.0},
                                {0.85, 0.08},
                                {0.85, 0.2},
                                {0.6, 0.3},
                                {0.25, 0.55},
                                {0.12, 0.9},
                                {0.0, 1.1}}),
                     {0.0, 4.0, 0.0});
  append(wood, moved(box(DVec3(0.7, 4.1 - floor, 0.1)), {0.0, 0.5 * (4.1 + floor), -0.58}));
  append(wood, pulpit_stairs({0.0, 0.0, 0.0}, floor));
  const Shape top_ball = moved(ellipsoid({0.09, 0.12, 0.09}, 14), {0.0, 5.12, 0.0});
  add_object(model, "Pulpit",
             moved({{m.white_marble, stone, 30.0},
                    {m.red_saint, saints},
                    {m.red_marble, shafts, 40.0},
                    {m.dark_oak, wood, 30.0},
                    {m.gold, top_ball, 60.0}},
                   place));
}

void add_font(Model& model, const Materials& m) {
  const DVec3 place(-1.6, 0.0, -2.0);
  const Shape steps = octagonal({{0.0, 0.0}, {0.85, 0.0}, {0.85, 0.14}, {0.0, 0.14}});
  Shape basin = octagonal({{0.0, 0.14},
                           {0.4, 0.14},
                           {0.4, 0.22},
                           {0.22, 0.3},
                           {0.18, 0.6},
                           {0.3, 0.68},
                           {0.52, 0.78},
                           {0.56, 0.8},
                           {0.56, 1.08},
                           {0.62, 1.12},
                           {0.62, 1.2},
                           {0.5, 1.2},
                           {0.45, 0.9},
                           {0.0, 0.88}});
  const Shape water = lathe({{0.49, 1.13}, {0.0, 1.13}}, 8);
  Shape rolls;
  for (int i = 0; i < 8; ++i) {
    append(rolls, turned(moved(shaft(0.045, 0.42, 8), {0.0, 0.2, 0.29}), 45.0 * i));
    const Shape rosette = turned(torus(0.07, 0.02, 12, 6), 90.0, {1, 0, 0});
    append(rolls, turned(moved(rosette, {0.0, 0.94, 0.515}), 45.0 * i));
  }
  add_object(model, "Baptismal font",
             moved({{m.dark_stone, steps, 30.0},
                    {m.white_marble, basin, 30.0},
                    {m.red_marble, rolls, 45.0},
                    {m.water, turned(water, 22.5)}},
                   place));
}

void add_pews(Model& model, const Materials& m) {
  const double length = 2.1;
  int number = 1;
  for (const double x : {0.3, 1.3, 2.3, 7.6, 8.6, 9.6}) {
    for (const double side : {-1.0, 1.0}) {
      const Shape wood = moved(pew(length), {x, 0.0, side * (0.8 + 0.5 * length)});
      const Shape grain = with_projected_uvs(wood, {0.5, 1.0, 0.0}, {0.0, 0.0, 0.5});
      add_object(model, "Pew " + std::to_string(number++), {{m.oak, grain, 40.0}});
    }
  }
}

void add_aisle_furniture(Model& model, const Materials& m) {
  int number = 1;
  for (const double side : {-1.0, 1.0}) {
    const DVec3 foot(half_length - 0.06, 1.5, side * 5.4);
    Shape stone =
        box({half_length - 0.8, 0.0, foot.z - 0.9}, {half_length - 0.12, 1.0, foot.z + 0.9});
    append(stone, box({half_length - 0.9, 1.0, foot.z - 1.0}, {half_length, 1.1, foot.z + 1.0}));
    Candles candles;
    for (const double z : {-0.7, 0.7}) {
      candles.add_candlestick({half_length - 0.5, 1.1, foot.z + z}, 0.4, 0.25);
    }
    std::vector<Part> parts = {
        {m.red_marble, with_uv_scale(stone, 0.7)},
        {side < 0.0 ? m.blue_saint : m.red_saint, west_picture(foot, 1.2, 2.4)},
        {m.gold, west_frame(foot + DVec3(0.02, 0.0, 0.0), 1.2, 2.4, 0.14)}};
    candles.append_to(parts, m);
    add_object(model, "Side altar " + std::to_string(number++), parts);
  }
  // A confessional: two compartments and the priest's between them.
  const DVec3 lower(-7.2, 0.0, aisle_z - 1.06);
  Shape wood = box(lower + DVec3(0.01, 0.0, 0.89), lower + DVec3(2.39, 2.3, 0.98));
  for (const double x : {0.0, 0.77, 1.55, 2.32}) {
    append(wood, box(lower + DVec3(x, 0.0, 0.0), lower + DVec3(x + 0.08, 2.3, 0.9)));
  }
  append(wood, box(lower + DVec3(-0.1, 2.3, -0.1), lower + DVec3(2.5, 2.45, 1.0)));
  append(wood, box(lower + DVec3(0.85, 0.0, 0.02), lower + DVec3(1.55, 1.1, 0.07)));
  append(wood, box(lower + DVec3(0.08, 0.4, 0.5), lower + DVec3(0.77, 0.45, 0.9)));
  append(wood, box(lower + DVec3(1.63, 0.4, 0.5), lower + DVec3(2.32, 0.45, 0.9)));
  add_object(model, "Confessional",
             {{m.dark_oak, with_projected_uvs(wood, {0.7, 0, 0.7}, {0, 0.7, 0})}});
}

}  // namespace foveola::scenes::church
