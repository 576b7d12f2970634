// The school room's walls and what is built into them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/parts.h"

namespace foveola::scenes::school {
namespace {

constexpr double outer_x = half_x + wall_thickness;
constexpr double outer_z = half_z + wall_thickness;
constexpr double door_left = -3.6;  ///< its lesser x
constexpr double door_width = 1.0;
constexpr double door_height = 2.1;

struct Span {
  double bottom;
  double top;
};

/// Calls visit(from, to) for each stretch of the window wall between openings.
template <typename Visit>
void for_each_pier(double from, double to, const Visit& visit) {
  double left = from;
  for (int i = 0; i < windows; ++i) {
    visit(left, window_x(i) - 0.5 * window_width);
    left = window_x(i) + 0.5 * window_width;
  }
  visit(left, to);
}

/// The long walls reach into the short ones, and the lintel into the ceiling: edges that only touch
/// would belong to two pieces.
Shape walls() {
  constexpr double overlap = 0.05;
  constexpr double reach = half_x + overlap;
  const double door_right = door_left + door_width;
  Shape shape;
  append(shape, box({half_x, 0.0, -outer_z}, {outer_x, ceiling, outer_z}));
  append(shape, box({-outer_x, 0.0, -outer_z}, {-half_x, ceiling, outer_z}));
  append(shape, box({-reach, 0.0, half_z}, {door_left, ceiling, outer_z}));
  append(shape, box({door_right, 0.0, half_z}, {reach, ceiling, outer_z}));
  append(shape, box({door_left, door_height, half_z}, {door_right, ceiling + overlap, outer_z}));
  append(shape, box({-reach, 0.0, -outer_z}, {reach, window_sill, -half_z}));
  append(shape, box({-reach, window_top, -outer_z}, {reach, ceiling, -half_z}));
  for_each_pier(-half_x, half_x, [&](double from, double to) {
    append(shape, box({from, window_sill, -outer_z}, {to, window_top, -half_z}));
  });
  return shape;
}

/// The painted lower part of the walls, `depth` thick from `bottom` to `top`; it spares the door
/// and, where it reaches above the sill, the windows.
Shape band(double bottom, double top, double depth) {
  Shape shape;
  append(shape, box({half_x - depth, bottom, -half_z}, {half_x, top, half_z}));
  append(shape, box({-half_x, bottom, -half_z}, {-half_x + depth, top, half_z}));
  const double left = -half_x + depth;
  const double right = half_x - depth;
  constexpr double door_frame = 0.1;
  append(shape, box({left, bottom, half_z - depth}, {door_left - door_frame, top, half_z}));
  append(shape,
         box({door_left + door_width + door_frame, bottom, half_z - depth}, {right, top, half_z}));
  const double sill = window_sill - 0.05;
  if (bottom < sill) {
    append(shape, box({left, bottom, -half_z}, {right, std::min(top, sill), -half_z + depth}));
  }
  if (top > sill) {
    for_each_pier(left, right, [&](double from, double to) {
      append(shape, box({from, std::max(bottom, sill), -half_z}, {to, top, -half_z + depth}));
    });
  }
  return shape;
}

/// A moulding's profile, out from the wall (x) and up (y), drawn along all four walls.
Shape moulding(const std::vector<DVec2>& profile) {
  Shape shape;
  const int rows = static_cast<int>(profile.size()) - 1;
  for (int side = 0; side < 4; ++side) {
    const double half_along = side % 2 == 0 ? half_x : half_z;
    const double half_across = side % 2 == 0 ? half_z : half_x;
    const Shape one = patch(1, rows, [&](double u, double v) {
      const DVec2& p = profile[static_cast<std::size_t>(std::lround(v * rows))];
      return DVec3((2.0 * u - 1.0) * (half_along - p.x), p.y, -half_across + p.x);
    });
    append(shape, turned(one, 90.0 * side));
  }
  return shape;
}

Shape window_frame() {
  constexpr double half = 0.5 * window_width;
  constexpr double height = window_top - window_sill;
  constexpr double transom = 1.32;
  Shape shape;
  const auto bar = [&](const DVec3& lower, const DVec3& upper) {
    const DVec3 size = upper - lower;
    append(shape, moved(rounded_box(size, 0.008, 1), 0.5 * (lower + upper)));
  };
  for (const double side : {-1.0, 1.0}) {
    const double x = side * (half - 0.035);
    bar({x - 0.035, 0.0, -0.04}, {x + 0.035, height, 0.04});
  }
  bar({-half + 0.06, 0.0, -0.038}, {half - 0.06, 0.07, 0.038});
  bar({-half + 0.06, height - 0.07, -0.038}, {half - 0.06, height, 0.038});
  bar({-half + 0.06, transom - 0.035, -0.045}, {half - 0.06, transom + 0.035, 0.045});
  bar({-0.03, 0.06, -0.04}, {0.03, height - 0.06, 0.04});
  for (const double side : {-1.0, 1.0}) {
    const double middle = side * (0.5 * half - 0.015);
    const double reach = 0.5 * half - 0.045;
    for (const auto& [bottom, top] :
         {Span{0.07, transom - 0.035}, Span{transom + 0.035, height - 0.07}}) {
      // The casement sits in front of the frame, as one that opens inwards does.
      for (const double edge : {-1.0, 1.0}) {
        const double x = middle + edge * (reach - 0.022);
        bar({x - 0.022, bottom, 0.01}, {x + 0.022, top, 0.065});
      }
      bar({middle - reach + 0.04, bottom, 0.012}, {middle + reach - 0.04, bottom + 0.045, 0.063});
      bar({middle - reach + 0.04, top - 0.045, 0.012}, {middle + reach - 0.04, top, 0.063});
    }
  }
  return shape;
}

Shape window_handles() {
  Shape shape;
  for (const double x : {-0.055, 0.055}) {
    append(shape, moved(rounded_box({0.03, 0.08, 0.012}, 0.005, 2), {x, 0.62, 0.07}));
    append(shape,
           tube(curve({{x, 0.62, 0.07}, {x, 0.62, 0.11}, {x, 0.6, 0.115}, {x, 0.5, 0.112}}, 3),
                0.008, 10));
  }
  return shape;
}

/// A cast-iron radiator of `ribs` ribs from x = 0, its feet on the origin's plane.
Shape radiator(int ribs) {
  constexpr double pitch = 0.055;
  constexpr double height = 0.62;
  const Shape column = lathe({{0.0, 0.08},
                              {0.014, 0.085},
                              {0.022, 0.1},
                              {0.019, 0.16},
                              {0.019, height - 0.08},
                              {0.022, height - 0.02},
                              {0.014, height - 0.003},
                              {0.0, height}},
                             10);
  Shape shape;
  for (int i = 0; i < ribs; ++i) {
    const double x = (i + 0.5) * pitch;
    for (const double z : {-0.045, 0.0, 0.045}) {
      append(shape, moved(column, {x, 0.0, z}));
    }
    for (const double y : {0.13, height - 0.05}) {
      append(shape, moved(rounded_box({0.034, 0.05, 0.13}, 0.015, 1), {x, y, 0.0}));
    }
    if (i == 1 || i == ribs - 2) {
      append(shape, moved(cone(0.026, 0.018, 0.1, 12), {x, 0.0, 0.045}));
      append(shape, moved(cone(0.026, 0.018, 0.1, 12), {x, 0.0, -0.045}));
    }
  }
  for (const double y : {0.13, height - 0.05}) {
    append(shape, tube({{0.01, y, 0.0}, {ribs * pitch - 0.01, y, 0.0}}, 0.018, 12));
  }
  const double end = ribs * pitch;
  append(shape, tube(curve({{end - 0.03, 0.13, 0.0},
                            {end + 0.08, 0.13, 0.0},
                            {end + 0.1, 0.11, 0.0},
                            {end + 0.1, 0.0, 0.0}},
                           4),
                     0.011, 10));
  append(shape, moved(turned(cylinder(0.024, 0.05, 16), -90.0, {0, 0, 1}), {end + 0.1, 0.13, 0.0}));
  return shape;
}

}  // namespace

void add_shell(Model& model, const Materials& m) {
  add_object(model, "Floor",
             {{m.parquet, with_uv_scale(box({-outer_x, -0.7, -outer_z}, {outer_x, 0.0, outer_z}),
                                        1.0 / 2.2)}});
  add_object(model, "Ceiling",
             {{m.ceiling,
               with_uv_scale(box({-outer_x, ceiling, -outer_z}, {outer_x, ceiling + 0.3, outer_z}),
                             1.0 / 1.25)}});
  add_object(model, "Walls", {{m.wall, with_uv_scale(walls(), 0.4)}});
  Shape rail = band(dado_height, dado_height + 0.045, 0.022);
  append(rail, band(0.0, 0.11, 0.02));
  add_object(model, "Dado",
             {{m.dado, with_uv_scale(band(0.11, dado_height, 0.008), 0.4)}, {m.dark_wood, rail}});
  std::vector<DVec2> cove = {
      {0.0, ceiling - 0.14}, {0.015, ceiling - 0.14}, {0.015, ceiling - 0.12}};
  constexpr int steps = 6;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / steps;
    cove.emplace_back(0.1 - 0.075 * std::cos(angle), ceiling - 0.11 + 0.085 * std::sin(angle));
  }
  cove.emplace_back(0.115, ceiling - 0.025);
  cove.emplace_back(0.115, ceiling);
  add_object(model, "Cornice", {{m.white_paint, moulding(cove)}});
}

void add_windows(Model& model, const Materials& m) {
  Shape frames;
  Shape handles;
  Shape sills;
  for (int i = 0; i < windows; ++i) {
    const DVec3 place(window_x(i), window_sill, -half_z - 0.2);
    append(frames, moved(window_frame(), place));
    append(handles, moved(window_handles(), place));
    append(sills, moved(rounded_box({window_width + 0.2, 0.035, 0.36}, 0.01, 2),
                        {window_x(i), window_sill - 0.01, -half_z + 0.03}));
    append(sills, moved(box(DVec3(window_width - 0.01, 0.03, 0.2)),
                        {window_x(i), window_sill + 0.005, -outer_z + 0.04}));
  }
  add_object(model, "Window frames", {{m.white_paint, frames}, {m.brass, handles, 60.0}});
  add_object(model, "Window sills", {{m.stone, with_uv_scale(sills, 0.8)}});
}

void add_curtains(Model& model, const Materials& m) {
  constexpr double rail_y = window_top + 0.12;
  constexpr double z = -half_z + 0.14;
  Shape cloths;
  Shape rail = tube({{-half_x + 0.1, rail_y, z}, {half_x - 0.1, rail_y, z}}, 0.014, 12);
  std::uint32_t number = 500;
  for (int i = 0; i <= windows; ++i) {
    // Drawn aside, the curtains hang in front of the piers.
    const double x = window_spacing * (i - 0.5 * windows);
    const bool is_outer = i == 0 || i == windows;
    const ClothSize size{
        .width = is_outer ? 0.42 : 0.56, .drop = 1.97, .folds = 7, .fold_depth = 0.05};
    append(cloths, moved(hanging_cloth(size, model.stream(++number)), {x, rail_y - 0.03, z}));
    for (int ring = 0; ring < 8; ++ring) {
      const double ring_x = x + size.width * (ring / 7.0 - 0.5);
      append(rail, moved(turned(torus(0.021, 0.0035, 20, 8), 90.0, {0, 0, 1}),
                         {ring_x, rail_y - 0.006, z}));
    }
    append(rail, tube({{x, rail_y, z}, {x, rail_y + 0.05, -half_z}}, 0.01, 8));
  }
  add_object(model, "Curtains", {{m.curtain, with_uv_scale(cloths, 1.0), 60.0}});
  add_object(model, "Curtain rail", {{m.brass, rail, 60.0}});
}

void add_radiators(Model& model, const Materials& m) {
  constexpr int ribs = 20;
  const Shape one = radiator(ribs);
  Shape all;
  for (int i = 0; i < windows; ++i) {
    append(all, moved(one, {window_x(i) - 0.55, 0.0, -half_z + 0.11}));
  }
  add_object(model, "Radiators", {{m.radiator, all, 50.0}});
}

void add_lamps(Model& model, const Materials& m) {
  constexpr double radius = 0.17;
  constexpr double y = ceiling - 0.62;
  Shape globes;
  Shape fittings;
  for (const double x : {-2.9, 0.0, 2.6}) {
    for (const double z : {-1.55, 1.55}) {
      append(globes, moved(ellipsoid({radius, 0.93 * radius, radius}, 28), {x, y, z}));
      append(fittings, moved(lathe({{0.075, radius * 0.84},
                                    {0.08, radius * 0.88},
                                    {0.078, radius * 0.98},
                                    {0.05, radius * 1.1},
                                    {0.03, radius * 1.3},
                                    {0.014, radius * 1.5},
                                    {0.0, radius * 1.5}},
                                   24),
                             {x, y, z}));
      append(fittings, tube({{x, y + radius * 1.4, z}, {x, ceiling - 0.02, z}}, 0.008, 10));
      append(fittings, moved(lathe({{0.0, -0.05}, {0.03, -0.048}, {0.055, -0.02}, {0.06, 0.0}}, 24),
                             {x, ceiling, z}));
    }
  }
  add_object(model, "Ceiling lamps", {{m.lamp, globes, 60.0}, {m.brass, fittings, 50.0}});
}

void add_door(Model& model, const Materials& m) {
  const double middle = door_left + 0.5 * door_width;
  Shape leaf =
      moved(box(DVec3(door_width, door_height, 0.04)), {middle, 0.5 * door_height, half_z + 0.06});
  Shape panels;
  for (const double side : {-1.0, 1.0}) {
    for (const auto& [bottom, top] : {Span{0.15, 0.85}, Span{1.05, 1.95}}) {
      append(panels, moved(rounded_box({0.36, top - bottom, 0.03}, 0.012, 3),
                           {middle + side * 0.23, 0.5 * (bottom + top), half_z + 0.04}));
    }
  }
  Shape frame;
  for (const double side : {-1.0, 1.0}) {
    append(frame, moved(rounded_box({0.1, door_height + 0.1, 0.06}, 0.012, 2),
                        {middle + side * (0.5 * door_width + 0.05), 0.5 * (door_height + 0.1),
                         half_z - 0.01}));
  }
  append(frame, moved(rounded_box({door_width + 0.24, 0.12, 0.07}, 0.012, 2),
                      {middle, door_height + 0.06, half_z - 0.012}));
  const DVec3 lock(door_left + door_width - 0.08, 1.03, half_z + 0.04);
  Shape handle = moved(rounded_box({0.045, 0.22, 0.012}, 0.005, 2), lock);
  append(handle, moved(tube(curve({{0.0, 0.03, 0.0},
                                   {0.0, 0.03, -0.05},
                                   {-0.02, 0.03, -0.06},
                                   {-0.12, 0.025, -0.058}},
                                  4),
                            0.01, 12),
                       lock));
  append(leaf, panels);
  add_object(model, "Door",
             {{m.dado, with_uv_scale(leaf, 0.4)}, {m.white_paint, frame}, {m.brass, handle, 60.0}});
  // What closes the opening behind the leaf, so that no light falls in around it.
  add_object(model, "Corridor",
             {{m.dark_wood, box({door_left, 0.0, half_z + 0.12},
                                {door_left + door_width, door_height, outer_z})}});
}

}  // namespace foveola::scenes::school
